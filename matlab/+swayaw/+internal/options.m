function words = options(pairs)
% Name, value, ... as words of the command line: true is a flag, false none; runs may be structs.
  if mod(numel(pairs), 2) ~= 0
    error('swayaw:refused', 'options come as name, value, ...; %d is odd', numel(pairs));
  end
  words.list = {};
  words.each = {};
  for k = 1:2:numel(pairs)
    name = ['--' strrep(char(pairs{k}), '_', '-')];
    value = pairs{k + 1};
    if islogical(value) && isscalar(value)
      if value
        words.list{end + 1} = name;
      end
    elseif isnumeric(value)
      words.list = [words.list, {name, sprintf('%.17g', value)}];
    else
      files = swayaw.internal.as_files(value);
      words.each{end + 1} = files;
      words.list = [words.list, {name}, files.list];
    end
  end
end
