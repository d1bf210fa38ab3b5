function answer = check(runs, varargin)
%SWAYAW.CHECK  Instruments of recordings, by kinematics alone: signs, units, noise, clocks, zeros, scales, axes.
%   ANSWER = swayaw.check(RUNS, NAME, VALUE, ...), RUNS a file, a struct of swayaw.recording, or a cell array of these.
%     answer = swayaw.check({'zz10.csv', 'turn35.csv'}, 'report', 'page.html');
  runs = swayaw.internal.as_files(runs);
  words = swayaw.internal.options(varargin);
  answer = swayaw.internal.answer_to([{'check'}, runs.list, words.list]);
end
