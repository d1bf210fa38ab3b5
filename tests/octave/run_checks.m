function run_checks(name)
% Runs NAME.m in an empty folder; it ends Octave with the number of sentences that are not true.
  checks = str2func(name);
  folder = tempname();
  mkdir(folder);
  cd(folder);
  failures = 0;
  try
    checks(@check);
  catch problem
    fprintf('%s\n', problem.message);
    arrayfun(@(at) fprintf('  in %s, line %d\n', at.name, at.line), problem.stack);
    failures = failures + 1;
  end
  cd('/');
  confirm_recursive_rmdir(false);
  rmdir(folder, 's');
  exit(min(failures, 100));

  function check(holds, sentence)
    if ~holds
      fprintf('not true: %s\n', sentence);
      failures = failures + 1;
    end
  end
end
