function answer = diagnose(ship, runs, varargin)
%SWAYAW.DIAGNOSE  What a model leaves out, and whether runs that were held out gain by it.
%   ANSWER = swayaw.diagnose(SHIP, RUNS, NAME, VALUE, ...) with files or structs.
%     answer = swayaw.diagnose('ship.toml', {'zz10.csv', 'turn35.csv'}, 'holdout', 'zz20.csv', 'report', 'page.html');
%     answer.verdict, answer.words, answer.effects
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  runs = swayaw.internal.as_files(runs);
  answer = swayaw.internal.answer_to([{'diagnose', ship.file}, runs.list, words.list]);
end
