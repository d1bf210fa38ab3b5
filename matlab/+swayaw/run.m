function answer = run(command, varargin)
%SWAYAW.RUN  Any command of the program, its JSON as a struct (docs/json.md).
%   ANSWER = swayaw.run(COMMAND, WORD, ...) with the words of the command line; numbers become words.
%     swayaw.run('forces', 'kvlcc2', '--state', 'u=7,v=-0.5,r=0.005,delta=0.2')
%     swayaw.run('estimate', '--length', 230, '--beam', 32.2, '--draught', 10.8, '--block', 0.651, '--out', 'ship.toml')
%   What the program refuses is an error, swayaw:refused, with its words. What it says besides goes to stderr.
  answer = swayaw.internal.answer_to([{command}, varargin]);
end
