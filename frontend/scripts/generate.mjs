// Writes the sources that are made from other files of the project.

import "./places.mjs";
import "./texts.mjs";
import "./wire.mjs";
