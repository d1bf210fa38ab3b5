function answer = trial(runs, varargin)
%SWAYAW.TRIAL  Recorded manoeuvres judged: overshoots, K and T, turning circle, IMO MSC.137(76).
%   ANSWER = swayaw.trial(RUNS, NAME, VALUE, ...), RUNS a file, a struct of swayaw.recording, or a cell array of these.
%     answer = swayaw.trial({'zz10.csv', 'turn35.csv'}, 'length', 320);
%     answer = swayaw.trial(recording, 'ship', 'kvlcc2');
  runs = swayaw.internal.as_files(runs);
  words = swayaw.internal.options(varargin);
  answer = swayaw.internal.answer_to([{'trial'}, runs.list, words.list]);
end
