function answer = compare(ship, runs, varargin)
%SWAYAW.COMPARE  Where a simulation and recordings differ: quantity, interval, region, size.
%   ANSWER = swayaw.compare(SHIP, RUNS, NAME, VALUE, ...) with files or structs.
%     answer = swayaw.compare('kvlcc2_l7', {'zz10.csv', 'turn35.csv'}, 'report', 'page.html');
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  runs = swayaw.internal.as_files(runs);
  answer = swayaw.internal.answer_to([{'compare', ship.file}, runs.list, words.list]);
end
