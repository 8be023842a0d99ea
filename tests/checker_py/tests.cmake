# The Python checker's unit tests.
set(star_box_2_parts star_box_2 star_box_2_body star_box_2_sheets star_box_2_work star_box_2_zeros star_box_2_flat star_box_2_turned
    star_box_long)
foreach(part IN ITEMS mesh mesh_reading mesh_reversed points patch_points expression_points star_box star_box_hostile star_box_turned star_box_itd model_g2 model_mfem model_faces ${star_box_2_parts}
        patch_invalid patch_invalid_2 volume_folded vmodel vmodel_invalid micro micro_bridges micro_inside micro_sweeps micro_spline collar collar_2)
  string(REGEX REPLACE "^(mesh|points)" "checker_py_\\1" name ${part})  # checker_py_mesh, checker_py_points, star_box, ...
  add_test(NAME ${name} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker_py/${part}_test.py")
  set_tests_properties(${name} PROPERTIES ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
endforeach()
veritope_tier(quick checker_py_mesh checker_py_mesh_reading checker_py_mesh_reversed)
veritope_tier(standard star_box star_box_hostile star_box_turned star_box_itd model_g2 model_mfem model_faces ${star_box_2_parts} patch_invalid
              patch_invalid_2 volume_folded vmodel vmodel_invalid micro micro_bridges micro_inside micro_sweeps micro_spline)
veritope_tier(standard collar_2 checker_py_points patch_points expression_points)
veritope_tier(full collar)  # 72 s, a third of it for 56,578 cells around a knot
