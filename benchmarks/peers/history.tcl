# One history in OpenSees. Called by ./moat bench peers:
#
#   OpenSees history.tcl MODEL MOTION INTERVAL STEP COUNT SETTING OUTPUT BASE TOP GAPS
#
# MODEL: Tcl that builds the model. MOTION: accelerations in m/s^2, one per line, INTERVAL s apart. COUNT steps of
# STEP s. SETTING: textbook, force_test or explicit. OUTPUT: beginning of the names of files. BASE, TOP: tags of nodes.
# GAPS: list of tags of elements; empty: no peaks are recorded.
#
# Prints `HISTORY`, 0 if all steps were solved, CPU seconds of the steps, then the peaks of displacement of base and top,
# of their absolute accelerations, and of the impact force. OpenSees prints on standard error.

lassign $argv model motion interval step count setting output base top gaps

proc cpu_seconds {} {
  set file [open /proc/self/schedstat]
  set text [read $file]
  close $file
  return [expr {[lindex $text 0] * 1e-9}]
}

wipe
source $model
timeSeries Path 1 -dt $interval -filePath $motion -factor 1.0
pattern UniformExcitation 1 1 -accel 1

if {[llength $gaps] > 0} {
  recorder EnvelopeNode -precision 12 -file $output.displacement -node $base $top -dof 1 disp
  recorder EnvelopeNode -precision 12 -file $output.acceleration -timeSeries 1 -node $base $top -dof 1 accel
  recorder EnvelopeElement -precision 12 -file $output.force -ele {*}$gaps force
}

constraints Plain
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
wipe

# The third line of an envelope holds largest magnitudes.
proc envelope {name} {
  set file [open $name]
  set lines [split [string trim [read $file]] \n]
  close $file
  return [lindex $lines 2]
}

set peaks {}
if {[llength $gaps] > 0} {
  set largest 0.0
  foreach force [envelope $output.force] {
    if {abs($force) > $largest} {set largest [expr {abs($force)}]}
  }
  set peaks [concat [envelope $output.displacement] [envelope $output.acceleration] $largest]
}
puts stderr "HISTORY $failed $taken $peaks"
