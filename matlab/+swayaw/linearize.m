function [system, answer, model] = linearize(ship, varargin)
%SWAYAW.LINEARIZE  Small motions of a nonlinear ship about a steady one, by exact derivatives.
%   SYSTEM = swayaw.linearize(SHIP, NAME, VALUE, ...) with the options of swayaw linearize:
%     system = swayaw.linearize('kvlcc2');
%     system = swayaw.linearize('ship.toml', 'speed', 6, 'rudder', 10);
%   SYSTEM is ss(A, B, C, D) where that is there (Control System Toolbox; in Octave pkg load control), else the struct
%   of these fields: states u [m/s], v [m/s], r [rad/s], input delta [rad], positive to port; time in seconds.
%   [SYSTEM, ANSWER, MODEL] also gives the JSON of the program and that struct: MODEL.nomoto is the transfer function
%   from rudder to yaw rate, MODEL.port and MODEL.starboard are there where turns to both sides differ.
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  file = swayaw.internal.scratch_file();
  answer = swayaw.internal.answer_to([{'linearize', ship.file}, words.list, {'--out', file.file}]);
  model = load(file.file);
  system = swayaw.internal.as_ss(model);
end
