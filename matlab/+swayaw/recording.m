function result = recording(source, file)
%SWAYAW.RECORDING  A recording as a struct of columns, and back.
%   R = swayaw.recording(FILE) of a recording (.csv, .mat): a column of numbers for each column of docs/formats.md,
%   R.time_s, R.psi_rad, ..., as the file has them, NaN where a sample is missing; texts as cell arrays; and the run
%   keys, R.manoeuvre, R.execute_s, R.rudder_positive.
%   swayaw.recording(R, FILE) writes R to FILE, .csv or .mat. R may be a table.
%     r = swayaw.recording('run.csv');  plot(r.y_m, r.x_m)
%     r.delta_rad = -r.delta_rad;  swayaw.recording(r, 'run.mat');
%   Numbers come back to the last bit. The other functions take R in place of a file.
  if nargin > 1
    write_recording(swayaw.internal.as_struct(source), file);
    result = file;
  elseif swayaw.internal.ends_with(source, '.mat')
    result = load(source);
    if ~isfield(result, 'time_s')
      result = recording_within(result, source);
    end
  else
    result = read_csv(source);
  end
end

function result = recording_within(variables, file)
% The one struct of the file that is a recording.
  names = fieldnames(variables);
  for k = 1:numel(names)
    result = variables.(names{k});
    if isstruct(result) && isfield(result, 'time_s')
      return
    end
  end
  error('swayaw:refused', '%s: no variable time_s, nor a struct with that field', file);
end

function write_recording(run, file)
  if ~isfield(run, 'time_s')
    error('swayaw:refused', '%s: a recording needs the field time_s', file);
  end
  if swayaw.internal.ends_with(file, '.mat')
    save(file, '-struct', 'run', '-v7');
  else
    write_csv(run, file);
  end
end

% ---------------------------------------------------------------- comma-separated text

function result = read_csv(file)
  lines = lines_of(file);
  result = struct();
  facts = struct();
  k = 1;
  while k <= numel(lines) && (isempty(strtrim(lines{k})) || lines{k}(1) == '#')
    facts = with_fact(facts, lines{k});
    k = k + 1;
  end
  if k > numel(lines)
    error('swayaw:refused', '%s:%d:1: no header row', file, max(k - 1, 1));
  end
  names = strtrim(cells_of(lines{k}));
  rows = lines(k + 1:end);
  rows = rows(~cellfun(@isempty, strtrim(rows)));
  cells = cell(numel(rows), numel(names));
  for i = 1:numel(rows)
    row = cellfun(@unquoted, cells_of(rows{i}), 'UniformOutput', false);
    if numel(row) ~= numel(names)
      error('swayaw:refused', '%s:%d:1: %d cells, but the header row has %d', file, k + i, numel(row), numel(names));
    end
    cells(i, :) = row;
  end
  for j = 1:numel(names)
    result.(swayaw.internal.valid_name(names{j})) = column_of(cells(:, j));
  end
  names = fieldnames(facts);
  for j = 1:numel(names)
    result.(names{j}) = facts.(names{j});
  end
end

function lines = lines_of(file)
  id = fopen(file, 'r', 'n', 'UTF-8');
  if id < 0
    error('swayaw:refused', '%s: cannot be read', file);
  end
  closes = onCleanup(@() fclose(id));
  text = fread(id, [1, Inf], '*char');
  lines = strsplit(strrep(text, char([13 10]), char(10)), char(10), 'CollapseDelimiters', false);
end

function cells = cells_of(line)
% A comma between quotes belongs to its cell.
  if ~any(line == '"')
    cells = strsplit(line, ',', 'CollapseDelimiters', false);
    return
  end
  outside = mod(cumsum(line == '"'), 2) == 0;
  ends = [find(line == ',' & outside), numel(line) + 1];
  cells = cell(1, numel(ends));
  from = 1;
  for k = 1:numel(ends)
    cells{k} = line(from:ends(k) - 1);
    from = ends(k) + 1;
  end
end

function cell = unquoted(cell)
  if any(cell == '"')
    cell = strrep(regexprep(strtrim(cell), '^"(.*)"$', '$1'), '""', '"');
  end
end

function column = column_of(cells)
% Numbers, NaN where a cell is empty; texts where one is none.
  cells = strtrim(cells);
  column = str2double(cells);
  is_missing = cellfun(@isempty, cells) | strcmpi(cells, 'nan');
  if any(isnan(column) & ~is_missing)
    column = cells;
  end
end

function facts = with_fact(facts, line)
% "# key = value": a text in quotes, a number, true or false, or a list of these; other values stay text.
  parts = regexp(line, '^#\s*([A-Za-z]\w*)\s*=\s*(.*?)\s*$', 'tokens', 'once');
  if isempty(parts)
    return
  end
  facts.(parts{1}) = value_in(parts{2});
end

function value = value_in(written)
  value = written;
  text = regexp(written, '^"([^"\\]*)"$', 'tokens', 'once');
  if ~isempty(text)
    value = text{1};
  elseif any(strcmp(written, {'true', 'false'}))
    value = strcmp(written, 'true');
  elseif ~isnan(str2double(written))
    value = str2double(written);
  elseif ~isempty(regexp(written, '^\[[^\[\]{}]*\]$', 'once'))
    value = cellfun(@value_in, strtrim(cells_of(written(2:end - 1))), 'UniformOutput', false);
  end
end

function write_csv(run, file)
  names = fieldnames(run);
  is_column = cellfun(@(name) is_long_as(run.(name), run.time_s), names);
  id = fopen(file, 'w', 'n', 'UTF-8');
  if id < 0
    error('swayaw:refused', '%s: cannot be written', file);
  end
  closes = onCleanup(@() fclose(id));
  facts = names(~is_column);
  for k = 1:numel(facts)
    fprintf(id, '# %s = %s\n', facts{k}, value_text(run.(facts{k}), facts{k}, file));
  end
  columns = names(is_column);
  fprintf(id, '%s\n', strjoin(columns', ','));
  cells = cell(numel(columns), numel(run.time_s));
  for k = 1:numel(columns)
    cells(k, :) = cells_with(run.(columns{k}));
  end
  fprintf(id, [strjoin(repmat({'%s'}, 1, numel(columns)), ',') '\n'], cells{:});
end

function answer = is_long_as(value, time)
% A row of cells is a list among the run keys.
  answer = numel(value) == numel(time) && ~ischar(value) && ~(iscell(value) && isrow(value) && ~isscalar(value));
end

function cells = cells_with(column)
  if iscell(column)
    cells = cellfun(@(text) ['"' strrep(text, '"', '""') '"'], column, 'UniformOutput', false);
    return
  end
  cells = cell(1, numel(column));
  for i = 1:numel(column)
    if ~isnan(column(i))
      cells{i} = sprintf('%.17g', column(i));
    else
      cells{i} = '';
    end
  end
end

function text = value_text(value, name, file)
  if islogical(value) && isscalar(value)
    words = {'false', 'true'};
    text = words{value + 1};
  elseif ischar(value)
    text = ['"' strrep(strrep(value, '\', '\\'), '"', '\"') '"'];
  elseif isnumeric(value) && isscalar(value)
    text = sprintf('%.17g', value);
  elseif iscell(value)
    quoted = cellfun(@(one) value_text(one, name, file), value, 'UniformOutput', false);
    text = ['[' strjoin(quoted(:)', ', ') ']'];
  else
    error('swayaw:refused', '%s: %s is neither as long as time_s nor a run key', file, name);
  end
end
