function ships(check)
% A ship is the same in a TOML file, a .mat file and a struct.
  for name = {'kvlcc2', 'mariner', 'wpcc_pi', 'wpcc_pu', 'tanker97', 'tanker97_abc', 'tanker97_nomoto'}
    ship = swayaw.ship(name{1});
    before = swayaw.run('ship', name{1});
    for ending = {'.toml', '.mat'}
      file = swayaw.ship(ship, [name{1} ending{1}]);
      after = swayaw.run('ship', file);
      check(isequal(after.parameters, before.parameters), [file ' has the same parameters']);
      check(isequal(swayaw.ship(file), ship), [file ' is the same struct']);
    end
  end

  ship = swayaw.ship('kvlcc2');
  check(strcmp(ship.units.particulars.length_m, 'm') && strcmp(ship.units.hull.N_v, '-'), 'units stand beside the numbers');
  answer = swayaw.run('ship', 'kvlcc2');
  parameter = answer.parameters.N_v;
  check(parameter.value == ship.hull.N_v, 'the struct has the values that the program tells');
  check(strcmp(parameter.table, 'hull') && strcmp(parameter.unit, '-') && parameter.standard_deviation > 0, ...
        'a parameter has a table, a unit and a deviation');

  turn = swayaw.simulate('kvlcc2', 'turn', 35);
  check(isequal(swayaw.simulate(ship, 'turn', 35), turn), 'a struct turns as her file does');
  ship.hull.N_v = 1.2 * ship.hull.N_v;
  other = swayaw.simulate(ship, 'turn', 35);
  check(other.advance_m ~= turn.advance_m, 'a changed coefficient changes the turn');
  ship.effect = struct('kind', {'steady_current', 'rudder_offset'}, 'current_speed_m_s', {0.5, []}, ...
                       'current_to_rad', {1.5, []}, 'offset_rad', {[], 0.02});
  again = swayaw.ship(swayaw.ship(ship, 'with_effects.toml'));
  check(strcmp(again.effect{1}.kind, 'steady_current') && again.effect{2}.offset_rad == 0.02, 'effects can be added');

  ship = swayaw.ship('kvlcc2');
  ship.hull.N_w = 1;
  words = refusal_of(@() swayaw.simulate(ship, 'turn', 35));
  check(~isempty(strfind(words, '.mat:1:1: ')) && ~isempty(strfind(words, 'N_w')), ['a key of no ship is named: ' words]);
  ship = swayaw.ship('kvlcc2');
  ship.particulars = rmfield(ship.particulars, 'length_m');
  words = refusal_of(@() swayaw.ship(ship, 'bad.toml'));
  check(~isempty(strfind(words, 'length_m')) && ~exist('bad.toml', 'file'), ['what is missing is named: ' words]);
end
