function [recording, answer] = replay(ship, run, varargin)
%SWAYAW.REPLAY  A recorded run simulated with its own rudder and shaft speed.
%   RECORDING = swayaw.replay(SHIP, RUN, NAME, VALUE, ...) is the simulated time series, a struct of columns.
%     simulated = swayaw.replay('kvlcc2_l7', 'zz10.csv', 'shaft', 'self-propulsion');
%   SHIP and RUN are files or structs of swayaw.ship and swayaw.recording.
%   [RECORDING, ANSWER] also gives the JSON of the program.
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  run = swayaw.internal.as_files(run);
  series = swayaw.internal.scratch_file();
  answer = swayaw.internal.answer_to([{'replay', ship.file}, run.list, words.list, {'--out', series.file}]);
  recording = load(series.file);
end
