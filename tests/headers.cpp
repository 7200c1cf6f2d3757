// A library has at least one file: test_headers has this.
