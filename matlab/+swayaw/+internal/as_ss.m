function system = as_ss(model)
% ss(A, B, C, D) with the names of the model; the model itself where there is no ss or no such matrices.
  system = model;
  if ~isfield(model, 'A')
    return
  end
  try
    system = ss(model.A, model.B, model.C, model.D);
  catch
    return
  end
  system.StateName = model.StateName;
  system.InputName = model.InputName;
  system.OutputName = model.OutputName;
end
