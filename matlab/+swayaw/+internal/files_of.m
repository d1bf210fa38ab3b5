function [ship, words] = files_of(ship, pairs)
% The ship as a file, and options as words.
  ship = swayaw.internal.as_file(ship);
  words = swayaw.internal.options(pairs);
end
