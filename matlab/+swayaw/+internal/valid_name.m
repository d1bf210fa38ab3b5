function name = valid_name(name)
% Letters, digits and '_', a letter first, as the program names variables.
  name = regexprep(regexprep(name, '^"|"$', ''), '[^A-Za-z0-9_]', '_');
  if isempty(name) || isempty(regexp(name(1), '[A-Za-z]', 'once'))
    name = ['x' name];
  end
  name = name(1:min(end, 63));
end
