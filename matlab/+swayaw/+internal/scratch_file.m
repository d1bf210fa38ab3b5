function scratch = scratch_file()
% A file of its own that goes when `scratch` does.
  scratch.file = [tempname() '.mat'];
  file = scratch.file;
  scratch.goes = onCleanup(@() remove(file));
end

function remove(file)
  if exist(file, 'file')
    delete(file);
  end
end
