------- OpenFAST INPUT FILE -------------------------------------------
A part of a main file, written by hand
---------------------- FEATURE SWITCHES AND FLAGS ------------------------------
1  CompElast   - Compute structural dynamics (switch) {1=ElastoDyn; 2=ElastoDyn + BeamDyn for blades}
---------------------- INPUT FILES ---------------------------------------------
"plain_ElastoDyn.dat"  EDFile      - Name of file containing ElastoDyn input parameters (quoted string)
"plain_BeamDyn.dat"  BDBldFile(1) - Name of file containing BeamDyn input parameters for blade 1 (quoted string)
"plain_BeamDyn.dat"  BDBldFile(2) - Name of file containing BeamDyn input parameters for blade 2 (quoted string)
"plain_BeamDyn.dat"  BDBldFile(3) - Name of file containing BeamDyn input parameters for blade 3 (quoted string)
