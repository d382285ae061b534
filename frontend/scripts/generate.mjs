// Writes the sources that are made from other files of the project.

import "./places.mjs";
import "./wire.mjs";
