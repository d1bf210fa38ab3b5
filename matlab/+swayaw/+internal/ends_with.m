function answer = ends_with(text, ending)
  n = numel(ending);
  answer = numel(text) >= n && strcmp(text(end - n + 1:end), ending);
end
