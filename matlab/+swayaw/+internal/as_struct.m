function value = as_struct(value)
% A struct, also of a table.
  if isa(value, 'table')
    value = table2struct(value, 'ToScalar', true);
  end
  if ~isstruct(value) || ~isscalar(value)
    error('swayaw:refused', 'a file name or a struct is needed, got %s', class(value));
  end
end
