"""How the tests are run: what each costs, in which pool, and what none may leave to the next."""
