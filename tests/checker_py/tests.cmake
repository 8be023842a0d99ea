# The Python checker's unit tests.
foreach(part IN ITEMS veritope_check star_box star_box_hostile star_box_turned star_box_itd patch_invalid collar)
  string(REPLACE veritope_check checker_py name ${part})  # checker_py, star_box, ...
  add_test(NAME ${name} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker_py/${part}_test.py")
  set_tests_properties(${name} PROPERTIES ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
endforeach()
veritope_tier(quick checker_py star_box_hostile)
veritope_tier(standard star_box star_box_turned star_box_itd patch_invalid)
veritope_tier(full collar)  # 72 s, a third of it for 56,578 cells around a knot
