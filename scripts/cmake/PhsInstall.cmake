# Install rules: see the end of the build description.
