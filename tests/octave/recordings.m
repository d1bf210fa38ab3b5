function recordings(check)
% A recording is the same in a CSV file, a .mat file and a struct, to the last bit.
  project = getenv('SWAYAW_PROJECT');
  [answer, run] = swayaw.simulate('kvlcc2', 'zigzag', '20/20', 'forces', true);
  check(numel(answer.overshoot_deg) >= 2, 'a zigzag has two overshoots');
  check(strcmp(run.rudder_positive, 'port') && run.execute_s == 0, 'run keys are fields');
  check(isfield(run, 'X_hull_N') && isfloat(run.X_hull_N), 'forces by part are columns of numbers');

  swayaw.run('simulate', 'kvlcc2', '--zigzag', '20/20', '--forces', '--out', 'run.csv');
  from_text = swayaw.recording('run.csv');
  check(isequaln(sorted(run), sorted(from_text)), 'the program writes the same numbers to both files');
  for ending = {'.csv', '.mat'}
    file = ['again' ending{1}];
    swayaw.recording(run, file);
    check(isequaln(sorted(swayaw.recording(file)), sorted(run)), [file ' comes back to the last bit']);
    swayaw.run('import', file, '--out', ['imported' ending{1}]);
    imported = swayaw.recording(['imported' ending{1}]);
    check(isequal(imported.psi_rad, run.psi_rad), [file ' can be imported']);
  end
  odd = run;
  odd.Groesse = repmat({'a, "b"'}, size(run.time_s));
  odd.extra_columns = {'Groesse', 'mast'};
  odd.order_recorded = true;
  odd.draughts_m = {10.5, 11};
  for ending = {'.csv', '.mat'}
    file = ['odd' ending{1}];
    swayaw.recording(odd, file);
    check(isequaln(sorted(swayaw.recording(file)), sorted(odd)), [file ': texts, lists and truths come back']);
    swayaw.run('import', file, '--out', ['imported' ending{1}]);
  end
  text = sprintf('# extra_columns = ["Größe [t]"]\ntime_s,psi_rad,delta_rad,Größe [t]\n0,0,0,1.5\n1,0,0,\n');
  file = fopen('umlaut.csv', 'w');
  fputs(file, text);
  fclose(file);
  umlaut = swayaw.recording('umlaut.csv');
  check(isequaln(umlaut.Gr__e__t_, [1.5; NaN]), 'names become those that the program gives them');

  save('-v7', 'struct.mat', 'run');
  check(isequaln(sorted(swayaw.recording('struct.mat')), sorted(run)), 'a struct within a file is found');

  answers = {swayaw.trial('run.csv'), swayaw.trial('again.mat'), swayaw.trial('struct.mat'), swayaw.trial(run)};
  for k = 2:numel(answers)
    check(isequal(told(answers{k}), told(answers{1})), 'a trial is judged alike, whatever holds it');
  end

  starboard = run;
  starboard.delta_rad = -run.delta_rad;
  starboard.rudder_positive = 'starboard';
  starboard.psi_deg = rad2deg(run.psi_rad);
  starboard = rmfield(starboard, {'psi_rad', 'delta_order_rad'}(isfield(starboard, {'psi_rad', 'delta_order_rad'})));
  simulated = swayaw.replay('kvlcc2', starboard);
  check(max(abs(simulated.psi_rad - run.psi_rad)) < 1e-3, 'a replay of other signs and units is the simulation');

  example = fullfile(project, 'examples', 'recordings', 'weak_rudder_zz10_10.csv');
  checked = swayaw.check({example, swayaw.recording(example)});
  check(numel(checked.runs) == 2, 'files and structs can be checked together');
  compared = swayaw.compare('kvlcc2_l7', swayaw.recording(example));
  check(strcmp(compared.schema, 'swayaw.comparison/1') || isfield(compared, 'runs'), 'a struct can be compared');

  late = run;
  late.time_s(3) = late.time_s(2);
  words = refusal_of(@() swayaw.check(late));
  check(~isempty(strfind(words, '.mat:1:1: time_s must increase')), ['a bad struct is refused in words: ' words]);
  words = refusal_of(@() swayaw.check(rmfield(run, {'psi_rad'})));
  check(~isempty(strfind(words, 'no heading column')), ['what is missing is named: ' words]);
  save('-text', 'text.mat', 'run');
  words = refusal_of(@() swayaw.trial('text.mat'));
  check(~isempty(strfind(words, 'save(''-v7'', ...)')), ['the format that Octave saves by itself is told: ' words]);
  words = refusal_of(@() swayaw.recording('none.csv'));
  check(strcmp(words, 'none.csv: cannot be read'), ['a file that is not there is named: ' words]);
  words = refusal_of(@() swayaw.simulate('kvlcc2', 'zigzag'));
  check(~isempty(strfind(words, 'name, value')), ['options come in pairs: ' words]);
  words = refusal_of(@() swayaw.simulate('kvlcc3', 'turn', 35));
  check(~isempty(strfind(words, 'did you mean "kvlcc2"')), ['a refusal has the words of the program: ' words]);
end

function result = sorted(run)
% The order of columns says nothing.
  result = orderfields(run);
end

function result = told(answer)
  result = answer.runs(1);
  for name = {'run', 'file', 'name'}
    if isfield(result, name{1})
      result = rmfield(result, name{1});
    end
  end
end
