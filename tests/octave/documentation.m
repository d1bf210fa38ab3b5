function documentation(check)
% The code blocks of docs/matlab.md run, one after the other, and each function says what it does.
  project = getenv('SWAYAW_PROJECT');
  examples = fullfile(project, 'examples', 'recordings');
  copyfile(fullfile(examples, 'weak_rudder_zz10_10.csv'), 'zz10.csv');
  copyfile(fullfile(examples, 'weak_rudder_turn35.csv'), 'turn35.csv');
  page = fileread(fullfile(project, 'docs', 'matlab.md'));
  blocks = regexp(page, '```matlab\n(.*?)```', 'tokens');
  check(numel(blocks) >= 4, 'the page has examples');
  for k = 1:numel(blocks)
    words = refusal_of(@() evalin('base', blocks{k}{1}));
    check(isempty(words), sprintf('example %d runs: %s', k, words));
  end
  files = dir(fullfile(project, 'matlab', '+swayaw', '*.m'));
  for k = 1:numel(files)
    name = files(k).name(1:end - 2);
    text = fileread(fullfile(project, 'matlab', '+swayaw', files(k).name));
    check(~isempty(strfind(text, ['%SWAYAW.' upper(name) '  '])), [name ' has help']);
    check(~isempty(strfind(page, ['swayaw.' name])), [name ' stands in docs/matlab.md']);
  end
end
