function path = program(new_path)
%SWAYAW.PROGRAM  The program that the functions of this package run.
%   PATH = swayaw.program tells it: "swayaw", which the system looks for, or what the environment variable
%   SWAYAW_PROGRAM says.
%   swayaw.program(PATH) sets it until MATLAB or Octave ends.
  persistent said
  if nargin > 0
    said = new_path;
  end
  if ~isempty(said)
    path = said;
  elseif ~isempty(getenv('SWAYAW_PROGRAM'))
    path = getenv('SWAYAW_PROGRAM');
  else
    path = 'swayaw';
  end
end
