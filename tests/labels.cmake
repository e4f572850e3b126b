# Each test has one label:
#   fast        what it tests is small: under 0.2 s each, and under a minute all together on two processors; a new test is this
#   slow        takes longer, by itself or since it loads what reads pictures
#   render      POV-Ray renders
#   readers     other programs read what is written: Blender, browsers, librsvg, PROJ's own
#   statistics  many draws against a law, or against what was measured
# Those of GoogleTest are known when ctest starts, which reads this file then (tests/CMakeLists.txt); tests/scripts reads it when it
# is configured. tests/scripts/labels_test.sh looks whether each test has one.

set(shatterpave_render_tests "Render|^GlassLook[.]|^scripts[.]frames$")
set(shatterpave_readers_tests "^SvgRendering[.]|^ReferenceSystem[.]AgreesWithProjinfo|^scripts[.](blender|blender_glass|dxf|gltf|measure|mitsuba|obj|quantities|serve|tutorials|usd)$")
set(shatterpave_statistics_tests
    "^(Pane|Preset|Pattern)Statistics[.]|^(SceneFit|Laws|CountLaw|Spread|GoodLayout|Random)[.]|^FractalSurface[.]Spectrum|^Counts[.]StayInRange")
string(JOIN "|" shatterpave_slow_tests
  "^scripts[.]"
  # geometry
  "^Fill[.]RefusesEndless" "^InscribedCircle[.]IsAsLarge" "^RegionFault[.](AgreesWith|TakesNearly)"
  # glass
  "^(ClosedRegion|Dice|FallenShards|RealPattern|Topology|Branches|Laminated)[.]" "CrackSurface" "CracksInASlab" "^Bodies" "^CrackMap[.]StaysInside"
  "^Growth[.](Thousands|Tips)" "^PrintedLaw[.]" "^GrowthClock[.]" "Joined" "Shard" "^Radials/Tubes"
  # paving
  "^(Bonds|BorderCourse|Colouring|Filling|HandLaying|Joining|Laying|Module|Variation)[.]" "EveryBond" "EveryField" "^Steps[.]AreNever" "^StoneBody[.]Rounded"
  "^StoneSurface[.](Split|Covers)"
  # measure
  "^(BareSpot|PavementMeasures|StoneStock)[.]"
  # relief
  "^OutOfFocus[.]"
  # scene
  "^Fuzz[.]" "^EnvironmentFile[.]TooLarge" "^GeoJsonFile[.]Crs" "^Svg[.]UseCannot" "^ReferenceSystem[.]"
  # the command, and the library as a whole
  "^Command[.]" "^Face.*(Slow|Threads)" "^FaceModel[.]Stones")

# shatterpave_label(TEST PROGRAM LABEL): sets the variable LABEL to that of the test, of a program of tests or of none.
function(shatterpave_label test program label)
  foreach(kind IN ITEMS render readers statistics slow)
    if(test MATCHES "${shatterpave_${kind}_tests}")
      set(${label} ${kind} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  # It loads OpenImageIO, which takes half a second.
  if(program STREQUAL "shatterpave_image_tests")
    set(${label} slow PARENT_SCOPE)
  else()
    set(${label} fast PARENT_SCOPE)
  endif()
endfunction()

# In ctest: the lists that gtest_discover_tests leaves. (Tests with a square bracket in their names would be in none of them.)
foreach(program IN ITEMS shatterpave_tests shatterpave_image_tests)
  foreach(test IN LISTS ${program}_TESTS)
    shatterpave_label("${test}" ${program} label)
    set_tests_properties("${test}" PROPERTIES LABELS ${label})
  endforeach()
endforeach()
