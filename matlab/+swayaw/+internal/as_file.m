function scratch = as_file(value)
% A file with that ship or recording: its name as it is, a struct in a scratch file.
  if ischar(value) || isa(value, 'string')
    scratch.file = char(value);
    return
  end
  value = swayaw.internal.as_struct(value);
  scratch = swayaw.internal.scratch_file();
  save(scratch.file, '-struct', 'value', '-v7');
end
