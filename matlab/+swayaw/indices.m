function [answer, system, model] = indices(ship, varargin)
%SWAYAW.INDICES  Coefficients, time constants, gains and stability of a ship in small motions.
%   ANSWER = swayaw.indices(SHIP) is the JSON of swayaw indices: a1 ... c2, T1, T2, T3b, T3w, Kb, Kw, stable, and with
%   units in ANSWER.dimensional.
%     answer = swayaw.indices('tanker97', 'speed', 7);
%   [ANSWER, SYSTEM, MODEL] also gives the coupled equations of v [m/s] and r [rad/s] as ss, and as a struct, as
%   swayaw.linearize does. Time constants alone may belong to no coupled equations: SYSTEM is then the struct MODEL with
%   its field nomoto.
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  file = swayaw.internal.scratch_file();
  answer = swayaw.internal.answer_to([{'indices', ship.file}, words.list, {'--out', file.file}]);
  model = load(file.file);
  system = swayaw.internal.as_ss(model);
end
