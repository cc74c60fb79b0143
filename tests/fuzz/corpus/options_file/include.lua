include "fuzz.lua" include "../x.lua" include "/etc/passwd"
