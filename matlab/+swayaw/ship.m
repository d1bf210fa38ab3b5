function result = ship(ship, file)
%SWAYAW.SHIP  A ship as a struct of her tables, and back.
%   S = swayaw.ship(SHIP) of a ship file (.toml, .mat) or the name of a published ship: the tables and keys of
%   docs/formats.md, S.hull.N_v for instance, in the units of the file, which S.units has in words.
%   swayaw.ship(S, FILE) writes S to FILE, .toml or .mat, after the program has read it and refused what no ship has.
%     s = swayaw.ship('kvlcc2');  s.hull.N_v = 1.1*s.hull.N_v;
%     swayaw.ship(s, 'other.toml');  answer = swayaw.simulate(s, 'zigzag', '10/10');
  source = swayaw.internal.as_file(ship);
  if nargin > 1
    swayaw.internal.call_program({'ship', source.file, '--out', file, '--json'});
    result = file;
    return
  end
  target = swayaw.internal.scratch_file();
  swayaw.internal.call_program({'ship', source.file, '--out', target.file, '--json'});
  result = load(target.file);
end
