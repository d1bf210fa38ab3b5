function files = as_files(values)
% Files of one or several; `files.list` has their names.
  if ~iscell(values)
    values = {values};
  end
  files.each = cellfun(@swayaw.internal.as_file, values(:)', 'UniformOutput', false);
  files.list = cellfun(@(one) one.file, files.each, 'UniformOutput', false);
end
