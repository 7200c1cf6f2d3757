echo("never ends);
