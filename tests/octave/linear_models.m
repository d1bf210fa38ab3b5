function linear_models(check)
% Matrices of the files are those of the program's JSON, and their transfer functions those of the matrices.
  for name = {'kvlcc2', 'mariner', 'wpcc_pi', 'wpcc_pu', 'tanker97', 'tanker97_abc'}
    [answer, ~, model] = swayaw.indices(name{1});
    check(is_same_as_json(model, answer), [name{1} ': A and B of sway and yaw are those of the JSON']);
    check(is_same_transfer(model), [name{1} ': r/delta follows from A and B']);
    check(abs(model.nomoto.K - answer.dimensional.K_r_per_s) <= 1e-15 * abs(model.nomoto.K), [name{1} ': K is that of the JSON']);
    check(isequal(swayaw.nomoto(name{1}), model.nomoto), [name{1} ': nomoto is that field']);
  end
  for name = {'kvlcc2', 'kvlcc2_l7', 'wpcc_pi'}
    at_service_speed = swayaw.indices(name{1});
    [~, answer, model] = swayaw.linearize(name{1}, 'speed', 0.9 * at_service_speed.dimensional.speed_m_s);
    check(isequal(size(model.A), [3 3]) && isequal(size(model.B), [3 1]), 'three motions, one rudder');
    poles = sort(eig(model.A));
    told = sort([answer.poles.real_per_s]' + 1i * [answer.poles.imaginary_per_s]');
    check(norm(poles - told) <= 1e-12 * norm(told), [name{1} ': poles of A are those of the JSON']);
    slim = model;
    slim.A = model.A(2:3, 2:3);
    slim.B = model.B(2:3);
    check(is_same_as_json(slim, answer), [name{1} ': its block of sway and yaw is that of the JSON']);
    check(is_same_transfer(slim), [name{1} ': r/delta follows from that block']);
    check(isequal(model.operating_point.u_m_s, answer.operating_point.u_m_s), 'the operating point is told');
    check(isfield(model, 'port') == isfield(answer, 'port'), 'both sides are there where they differ');
  end
  [system, answer] = swayaw.linearize('kvlcc2', 'rudder', 10);
  check(answer.operating_point.delta_rad == deg2rad(10), 'a turn can be linearized about');
  check(isequal(system.StateName, {'u'; 'v'; 'r'}) && isequal(system.InputName, {'delta'}), 'states and input have names');

  % T3b = T3w: no coupled equations, but a transfer function
  ship = swayaw.ship('tanker97_nomoto');
  ship.nomoto.T3b = ship.nomoto.T3w;
  [~, system, model] = swayaw.indices(ship);
  check(~isfield(model, 'A') && isequal(system, model), 'indices alone give no matrices');
  check(all(isfinite([model.nomoto.num, model.nomoto.den])), 'but a transfer function');

  words = refusal_of(@() swayaw.run('linearize', 'kvlcc2', '--out', 'model.csv'));
  check(~isempty(strfind(words, 'must end in .mat')), ['a linear model is a .mat file: ' words]);
end

function answer = is_same_as_json(model, json)
% jsondecode of Octave loses the last bits.
  d = json.dimensional;
  A = [d.v_v_per_s, d.v_r_m_per_s; d.r_v_per_m_s, d.r_r_per_s];
  B = [d.v_delta_m_per_s2; d.r_delta_per_s2];
  answer = all(abs(model.A(:) - A(:)) <= 1e-13 * abs(A(:))) && all(abs(model.B - B) <= 1e-13 * abs(B));
end

function answer = is_same_transfer(model)
% (sI - A)^-1 B at a few frequencies, against num/den
  answer = true;
  for frequency = [0.01, 0.1, 1]
    s = 1i * frequency;
    by_matrices = [0, 1] * ((s * eye(2) - model.A) \ model.B);
    by_nomoto = polyval(model.nomoto.num, s) / polyval(model.nomoto.den, s);
    answer = answer && abs(by_matrices - by_nomoto) <= 1e-9 * abs(by_nomoto);
  end
end
