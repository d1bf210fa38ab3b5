function text = call_program(words)
% What the program prints; its refusal as an error, its notes to stderr.
  out = swayaw.internal.scratch_file();
  notes = swayaw.internal.scratch_file();
  words = cellfun(@word_of, words, 'UniformOutput', false);
  command = strjoin([{quoted(swayaw.program())}, cellfun(@quoted, words, 'UniformOutput', false)], ' ');
  if isunix() && ~is_octave()
    command = ['LD_LIBRARY_PATH= ' command];  % MATLAB's own libraries are older than the program's
  end
  status = system([command ' > ' quoted(out.file) ' 2> ' quoted(notes.file)]);
  told = strtrim(fileread(notes.file));
  if status ~= 0
    if isempty(told)
      told = sprintf('%s ended with %d', swayaw.program(), status);
    end
    error('swayaw:refused', '%s', told);
  end
  if ~isempty(told)
    fprintf(2, '%s\n', told);
  end
  text = fileread(out.file);
end

function word = word_of(value)
  if isnumeric(value)
    word = sprintf('%.17g', value);
  else
    word = char(value);
  end
end

function word = quoted(word)
  if ispc()
    word = ['"' strrep(word, '"', '\"') '"'];
  else
    word = ['''' strrep(word, '''', '''\''''') ''''];
  end
end

function answer = is_octave()
  answer = exist('OCTAVE_VERSION', 'builtin') ~= 0;
end
