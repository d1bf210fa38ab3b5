function model = nomoto(ship, varargin)
%SWAYAW.NOMOTO  Nomoto's equations of a ship: yaw rate [rad/s] by rudder angle [rad], time in seconds.
%   MODEL = swayaw.nomoto(SHIP, NAME, VALUE, ...) has the fields
%     num, den                            K (1 + T3 s)/((1 + T1 s)(1 + T2 s)), as num/den with den(1) = 1
%     K, T1, T2, T3                       T1 and T2 are NaN where the poles are a complex pair
%     T, first_order_num, first_order_den K/(1 + T s), T = T1 + T2 - T3
%   The rudder is positive to port, so a stable ship has K < 0; where rudders are positive to starboard it is -K.
%     n = swayaw.nomoto('kvlcc2', 'speed', 7);  bode(tf(n.num, n.den))
  [ship, words] = swayaw.internal.files_of(ship, varargin);
  file = swayaw.internal.scratch_file();
  swayaw.internal.answer_to([{'indices', ship.file}, words.list, {'--out', file.file}]);
  model = getfield(load(file.file), 'nomoto');
end
