% The five-storey building of five_storey_equations.hpp with one of Octave's own integrators, as a user would write it:
% the equations as matrices, changes of regime as events. A step is at most intervals_per_step intervals of the samples,
% which also keeps events in place: Octave puts them where a straight line between two steps does. Prints CPU time in seconds and the five peaks.
function five_storeys(motion_file, solver, relative_tolerance, intervals_per_step)
  motion = load(motion_file);
  interval = motion(1);
  samples = motion(2:end);
  duration = (numel(samples) - 1) * interval;
  building = make_building();
  regimes = struct('sliding', 0, 'slip', 0, 'side', 0, 'released', false, 'approach_speed', 1);

  % Octave warns at every event that ends a stretch.
  warning('off', 'integrate_adaptive:unexpected_termination');
  started = cputime();
  time = 0;
  state = zeros(12, 1);
  peaks = zeros(1, 5);
  while time < duration * (1 - 1e-12)
    [stiffness, constant] = bearing_line(building, regimes);
    matrix = building.matrix;
    matrix(7, 1) -= stiffness / building.base_mass;
    offset = building.ground;
    push = [zeros(6, 1); 1; zeros(5, 1)] / building.base_mass;
    rate = @(t, y) matrix * y - push * (constant + regimes.side * wall_force(building, regimes, y(1), y(7))) ...
                   - offset * ground_acceleration(t, interval, samples);
    bounds = box_of(building, regimes);
    options = odeset('RelTol', relative_tolerance, 'AbsTol', relative_tolerance * [0.01 * ones(6, 1); 0.1 * ones(6, 1)], ...
                     'MaxStep', intervals_per_step * interval, 'InitialStep', interval / 4, 'Events', @(t, y) margins(bounds, y));
    if strcmp(solver, 'ode23s')
      [t, y, event_time, event_state, event_side] = ode23s(rate, [time, duration], state, options);
    else
      [t, y, event_time, event_state, event_side] = ode45(rate, [time, duration], state, options);
    end
    peaks = max(peaks, peaks_of(building, regimes, matrix, push, constant, t, y, interval, samples));
    time = t(end);
    state = y(end, :).';
    if ! isempty(event_side) && time < duration * (1 - 1e-12)
      regimes = beyond(building, regimes, event_side(end), state(1), state(7));
    end
  end
  printf('%.6g', cputime() - started);
  printf(' %.12g', peaks);
  printf("\n");
end

function building = make_building()
  building.base_mass = 550e3;
  floor_mass = 500e3;
  square = 1e9 / floor_mass;
  frequency = @(mode) 2 * sqrt(square) * sin((2 * mode - 1) * pi / 22);
  mass_factor = 0.1 * frequency(1) * frequency(2) / (frequency(1) + frequency(2));
  stiffness_factor = 0.1 / (frequency(1) + frequency(2));
  building.yield_displacement = 0.01;
  building.elastic_stiffness = 193e6;
  building.post_yield_stiffness = 19.3e6;
  building.gap = 0.1;
  building.impact_stiffness = 2.95e9;
  building.impact_damping = 0.75 * (1 - 0.65 ^ 2);
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

function a = ground_acceleration(t, interval, samples)
  position = t / interval;
  before = min(floor(position), numel(samples) - 2);
  fraction = position - before;
  a = samples(before + 1) .* (1 - fraction) + samples(before + 2) .* fraction;
end

function [stiffness, constant] = bearing_line(building, regimes)
  sliding_part = building.elastic_stiffness - building.post_yield_stiffness;
  if regimes.sliding != 0
    stiffness = building.post_yield_stiffness;
    constant = sliding_part * regimes.sliding * building.yield_displacement;
  else
    stiffness = building.elastic_stiffness;
    constant = -sliding_part * regimes.slip;
  end
end

function force = wall_force(building, regimes, base, velocity)
  force = zeros(size(base));
  if regimes.side == 0 || regimes.released
    return;
  end
  indentation = max(regimes.side * base - building.gap, 0);
  ratio = min(max(regimes.side * velocity / regimes.approach_speed, -100), 100);
  force = building.impact_stiffness * indentation .^ 1.5 .* (1 + building.impact_damping * ratio);
end

% Least and greatest displacement and velocity of the base in these regimes; second column: whether it is the wall's.
function bounds = box_of(building, regimes)
  bounds = [-Inf, 0; Inf, 0; -Inf, 0; Inf, 0];
  reach = building.yield_displacement * (1 + 1e-9);
  if regimes.sliding == 0
    bounds(1, :) = [regimes.slip - reach, 0];
    bounds(2, :) = [regimes.slip + reach, 0];
  elseif regimes.sliding > 0
    bounds(3, :) = [0, 0];
  else
    bounds(4, :) = [0, 0];
  end
  if regimes.side == 0
    if -building.gap > bounds(1, 1), bounds(1, :) = [-building.gap, 1]; end
    if building.gap < bounds(2, 1), bounds(2, :) = [building.gap, 1]; end
    return;
  end
  right = regimes.side > 0;
  wall = regimes.side * building.gap;
  speed = -regimes.side * regimes.approach_speed / building.impact_damping;
  if right && wall > bounds(1, 1), bounds(1, :) = [wall, 1]; end
  if ! right && wall < bounds(2, 1), bounds(2, :) = [wall, 1]; end
  if right != regimes.released
    if speed > bounds(3, 1), bounds(3, :) = [speed * (1 - 1e-9 * regimes.released), 1]; end
  else
    if speed < bounds(4, 1), bounds(4, :) = [speed * (1 - 1e-9 * regimes.released), 1]; end
  end
end

function [margin, terminal, direction] = margins(bounds, y)
  margin = [y(1) - bounds(1, 1); bounds(2, 1) - y(1); y(7) - bounds(3, 1); bounds(4, 1) - y(7)];
  margin(! isfinite(margin)) = 1;
  terminal = ones(4, 1);
  direction = -ones(4, 1);
end

function regimes = beyond(building, regimes, side, base, velocity)
  bounds = box_of(building, regimes);
  if ! bounds(side, 2)
    if regimes.sliding == 0
      regimes.sliding = 2 * (side == 2) - 1;
    else
      regimes.slip = base - regimes.sliding * building.yield_displacement;
      regimes.sliding = 0;
    end
  elseif regimes.side == 0
    regimes.side = 2 * (side == 2) - 1;
    regimes.released = false;
    regimes.approach_speed = max(regimes.side * velocity, 1e-4);
  elseif side <= 2
    regimes.side = 0;
  else
    regimes.released = ! regimes.released;
  end
end

% Over continuous time: where neighbouring samples turn, the vertex of the parabola through three counts.
function peaks = peaks_of(building, regimes, matrix, push, constant, t, y, interval, samples)
  force = wall_force(building, regimes, y(:, 1), y(:, 7));
  absolute = y * matrix.' - (constant + regimes.side * force) * push.';
  series = [y(:, 1), y(:, 6), absolute(:, 7), absolute(:, 12), force];
  peaks = max(abs(series), [], 1);
  if numel(t) < 3
    return;
  end
  step = diff(t);
  rise = diff(series);
  slope = rise ./ max(step, eps);
  before = step(1:end - 1);
  after = step(2:end);
  curvature = (slope(2:end, :) - slope(1:end - 1, :)) ./ (before + after);
  middle = (slope(1:end - 1, :) .* after + slope(2:end, :) .* before) ./ (before + after);
  vertex = abs(series(2:end - 1, :) - 0.25 * middle .^ 2 ./ curvature);
  turns = rise(1:end - 1, :) .* rise(2:end, :) < 0;
  vertex(! turns) = 0;
  peaks = max(peaks, max(vertex, [], 1));
end
