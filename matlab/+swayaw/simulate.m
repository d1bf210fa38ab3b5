function [answer, recording] = simulate(ship, varargin)
%SWAYAW.SIMULATE  A standard manoeuvre and its indices.
%   ANSWER = swayaw.simulate(SHIP, NAME, VALUE, ...) with the options of swayaw simulate:
%     answer = swayaw.simulate('kvlcc2', 'zigzag', '20/20');
%     answer = swayaw.simulate('ship.toml', 'turn', 35, 'first', 'port', 'speed', 6);
%     answer = swayaw.simulate(ship, 'imo', true);
%   SHIP is a ship file (.toml, .mat), the name of a published ship, or a struct of swayaw.ship.
%   [ANSWER, RECORDING] also gives the time series, a struct of columns as swayaw.recording has them: SI units and
%   radians, rudder positive to port.
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  if nargout < 2
    answer = swayaw.internal.answer_to([{'simulate', ship.file}, words.list]);
    return
  end
  series = swayaw.internal.scratch_file();
  answer = swayaw.internal.answer_to([{'simulate', ship.file}, words.list, {'--out', series.file}]);
  recording = load(series.file);
end
