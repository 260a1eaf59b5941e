"""Types of the module; the docstrings are in the module itself."""

# --- Setup: constructors and matrices

# --- Setup: unproject, project, cloud

# --- Scene

# --- diagnose

# --- landmarks
