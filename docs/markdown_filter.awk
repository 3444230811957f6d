# For Doxygen, which reads the documents through this filter: formulas of GitHub's Markdown become those of Doxygen.
/^```math$/ { print "\\f["; formula = 1; next }
formula && /^```$/ { print "\\f]"; formula = 0; next }
{ print }
