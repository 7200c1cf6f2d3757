// A library has at least one file: csgscope_headers has this.
