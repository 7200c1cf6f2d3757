echo(“hello”);
