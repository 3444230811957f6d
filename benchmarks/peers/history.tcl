# One history in OpenSees. Called by ./moat bench peers:
#
#   OpenSees history.tcl MODEL MOTIONS INTERVAL STEP COUNT SETTING OUTPUT COMPARED BASE TOP ELEMENTS
#
# MODEL: Tcl that builds the model. MOTIONS: list of one or two files, for x and y: accelerations in m/s^2, one per line,
# INTERVAL s apart. COUNT steps of STEP s. SETTING: textbook, force_test or explicit. OUTPUT: beginning of the names of
# files. COMPARED: impacts, isolation, plan or rebounds; benchmarks/peers/building.hpp says what they are. BASE, TOP: tags
# of nodes. ELEMENTS: list of tags.
#
# Prints `HISTORY`, 0 if all steps were solved, CPU seconds of the steps, then the values that are compared.
#
# OpenSees prints on standard error.

lassign $argv model motions interval step count setting output compared base top elements

# The kernel brings its count up to date when the process sleeps.
proc cpu_seconds {} {
  after 1
  set file [open /proc/self/schedstat]
  set text [read $file]
  close $file
  return [expr {[lindex $text 0] * 1e-9}]
}

wipe
source $model
set direction 0
foreach motion $motions {
  incr direction
  timeSeries Path $direction -dt $interval -filePath $motion -factor 1.0
  pattern UniformExcitation $direction $direction -accel $direction
}

set files {}
proc record {kind args} {
  set name $::output.[llength $::files]
  recorder $kind -precision 12 -file $name {*}$args
  lappend ::files $name
}
switch $compared {
  impacts {
    record EnvelopeNode -node $base $top -dof 1 disp
    record EnvelopeNode -timeSeries 1 -node $base $top -dof 1 accel
    record EnvelopeElement -ele {*}$elements force
  }
  isolation {
    record EnvelopeNode -node $base $top -dof 1 disp
    record EnvelopeNode -node $base -dof 1 vel
    record EnvelopeNode -timeSeries 1 -node $top -dof 1 accel
    record EnvelopeElement -ele {*}$elements force
  }
  plan {
    record EnvelopeNode -node $base -dof 1 2 disp
    record EnvelopeNode -timeSeries 1 2 -node $top -dof 1 2 accel
    record EnvelopeNode -node $base -dof 6 disp
  }
}

# Points of a rigid floor follow it.
constraints [expr {$compared eq "plan" ? "Transformation" : "Plain"}]
numberer Plain
# The fastest of its solvers for these models.
system ProfileSPD
switch $setting {
  textbook {
    test NormDispIncr 1e-8 25 0
    integrator Newmark 0.5 0.25
    algorithm Newton
  }
  force_test {
    test NormUnbalance 10.0 25 0
    integrator Newmark 0.5 0.16666666666666667
    algorithm Newton
  }
  explicit {
    test NormDispIncr 1e-8 25 0
    integrator NewmarkExplicit 0.5
    algorithm Linear -factorOnce
  }
}
analysis Transient

set start [cpu_seconds]
set failed [analyze $count $step]
set taken [expr {[cpu_seconds] - $start}]
set values {}
if {$compared eq "rebounds"} {
  for {set node $base} {$node <= $top} {incr node} {lappend values [string trim [nodeVel $node 1]]}
}
wipe

# The third line of an envelope holds largest magnitudes. The last file counts by its largest: that of both ends of
# elements.
foreach name $files {
  set file [open $name]
  set magnitudes [lindex [split [string trim [read $file]] \n] 2]
  close $file
  if {$name eq [lindex $files end]} {
    set magnitudes [lindex [lsort -real -decreasing [lmap value $magnitudes {expr {abs($value)}}]] 0]
  }
  set values [concat $values $magnitudes]
}
puts stderr "HISTORY $failed $taken $values"
