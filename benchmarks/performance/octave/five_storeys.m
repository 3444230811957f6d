% The five-storey building of five_storey_equations.hpp by ode45, as a user would write it: the equations as matrices,
% changes of regime as events. Octave puts events where a straight line between two steps does; the tolerance and steps
% of at most 20 intervals keep them in place. Prints CPU time in seconds and the five peaks.
function five_storeys(motion_file)
  motion = load(motion_file);
  interval = motion(1);
  samples = motion(2:end);
  duration = (numel(samples) - 1) * interval;
  building = make_building();
  regimes = struct('sliding', 0, 'slip', 0, 'side', 0, 'released', false, 'approach_speed', 1);
  tolerance = 3e-7;

  % Octave warns at every event that ends a stretch.
  warning('off', 'integrate_adaptive:unexpected_termination');
  seconds = 0;
  time = 0;
  state = zeros(12, 1);
  peaks = zeros(1, 5);
  while time < duration * (1 - 1e-12)
    rate = @(t, y) absolute_rate(building, regimes, y) - building.ground * ground_acceleration(t, interval, samples);
    options = odeset('RelTol', tolerance, 'AbsTol', tolerance * [0.01 * ones(6, 1); 0.1 * ones(6, 1)], ...
                     'MaxStep', 20 * interval, 'InitialStep', interval / 4, 'Events', @(t, y) margins(building, regimes, y));
    started = cputime();
    [t, y, event_time, event_state, event] = ode45(rate, [time, duration], state, options);
    seconds += cputime() - started;
    peaks = max(peaks, peaks_of(building, regimes, t, y));
    time = t(end);
    state = y(end, :).';
    if ! isempty(event) && time < duration * (1 - 1e-12)
      regimes = beyond(building, regimes, event(end), state(1), state(7));
    end
  end
  printf('%.6g', seconds);
  printf(' %.12g', peaks);
  printf("\n");
end

function building = make_building()
  floor_mass = 500e3;
  building = struct('base_mass', 550e3, 'yield_displacement', 0.01, 'elastic_stiffness', 193e6, ...
                    'post_yield_stiffness', 19.3e6, 'gap', 0.1, 'impact_stiffness', 2.95e9, ...
                    'impact_damping', 0.75 * (1 - 0.65 ^ 2));
  square = 1e9 / floor_mass;
  frequency = @(mode) 2 * sqrt(square) * sin((2 * mode - 1) * pi / 22);
  mass_factor = 0.1 * frequency(1) * frequency(2) / (frequency(1) + frequency(2));
  stiffness_factor = 0.1 / (frequency(1) + frequency(2));
  storeys = zeros(6);
  drags = zeros(6);
  for i = 2:6
    storeys([i - 1, i], [i - 1, i]) += [1, -1; -1, 1];
    drags([1, i], [1, i]) += [1, -1; -1, 1];
  end
  per_mass = diag([floor_mass / building.base_mass; ones(5, 1)]);
  building.matrix = [zeros(6), eye(6); ...
                     -per_mass * square * storeys, -per_mass * (square * stiffness_factor * storeys + mass_factor * drags)];
  building.ground = [zeros(6, 1); ones(6, 1)];
end

% Velocities and absolute accelerations.
function rate = absolute_rate(building, regimes, y)
  sliding_part = building.elastic_stiffness - building.post_yield_stiffness;
  stretch = y(1) - regimes.slip;
  if regimes.sliding != 0, stretch = regimes.sliding * building.yield_displacement; end
  bearing = building.post_yield_stiffness * y(1) + sliding_part * stretch;
  rate = building.matrix * y;
  rate(7) -= (bearing + regimes.side * wall_force(building, regimes, y(1), y(7))) / building.base_mass;
end

function a = ground_acceleration(t, interval, samples)
  position = t / interval;
  before = min(floor(position), numel(samples) - 2);
  fraction = position - before;
  a = samples(before + 1) .* (1 - fraction) + samples(before + 2) .* fraction;
end

function factor = damping_factor(building, regimes, velocity)
  factor = 1 + building.impact_damping * min(max(regimes.side * velocity / regimes.approach_speed, -100), 100);
end

function force = wall_force(building, regimes, base, velocity)
  indentation = max(regimes.side * base - building.gap, 0);
  force = building.impact_stiffness * indentation ^ 1.5 * damping_factor(building, regimes, velocity);
  if regimes.side == 0 || regimes.released, force = 0; end
end

% Of the bearing, of the gap, and of the force of a contact; an event where one falls below zero.
function [margin, terminal, direction] = margins(building, regimes, y)
  margin = [regimes.sliding * y(7); regimes.side * y(1) - building.gap; 1];
  if regimes.sliding == 0, margin(1) = building.yield_displacement * (1 + 1e-9) - abs(y(1) - regimes.slip); end
  if regimes.side == 0
    margin(2) = building.gap - abs(y(1));
  else
    margin(3) = damping_factor(building, regimes, y(7));
    if regimes.released, margin(3) = 1e-9 - margin(3); end
  end
  terminal = ones(3, 1);
  direction = -ones(3, 1);
end

function regimes = beyond(building, regimes, event, base, velocity)
  if event == 1 && regimes.sliding == 0
    regimes.sliding = sign(base - regimes.slip);
  elseif event == 1
    regimes.slip = base - regimes.sliding * building.yield_displacement;
    regimes.sliding = 0;
  elseif event == 2 && regimes.side == 0
    regimes.side = sign(base);
    regimes.released = false;
    regimes.approach_speed = max(regimes.side * velocity, 1e-4);
  elseif event == 2
    regimes.side = 0;
  else
    regimes.released = ! regimes.released;
  end
end

% Over continuous time: where neighbouring samples turn, the vertex of the parabola through three counts.
function peaks = peaks_of(building, regimes, t, y)
  series = zeros(numel(t), 5);
  for i = 1:numel(t)
    rate = absolute_rate(building, regimes, y(i, :).');
    series(i, :) = [y(i, 1), y(i, 6), rate(7), rate(12), wall_force(building, regimes, y(i, 1), y(i, 7))];
  end
  peaks = max(abs(series), [], 1);
  if numel(t) < 3, return; end
  step = diff(t);
  slope = diff(series) ./ max(step, eps);
  before = step(1:end - 1);
  after = step(2:end);
  curvature = (slope(2:end, :) - slope(1:end - 1, :)) ./ (before + after);
  middle = (slope(1:end - 1, :) .* after + slope(2:end, :) .* before) ./ (before + after);
  vertex = abs(series(2:end - 1, :) - 0.25 * middle .^ 2 ./ curvature);
  vertex(slope(1:end - 1, :) .* slope(2:end, :) >= 0) = 0;
  peaks = max(peaks, max(vertex, [], 1));
end
