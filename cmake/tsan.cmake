# Builds with the thread sanitizer link tsan_order.cc into every program, before all other libraries.
if(FOVEA_SANITIZE MATCHES thread)
  add_library(fovea_tsan_order SHARED cmake/tsan_order.cc)
  fovea_target(fovea_tsan_order)
  target_include_directories(fovea_tsan_order SYSTEM PRIVATE ${OpenCV_INCLUDE_DIRS})
  target_link_libraries(fovea_tsan_order PRIVATE gRPC::grpc absl::synchronization absl::status
                                                 opencv_core ${CMAKE_DL_LIBS})
  link_libraries(fovea_tsan_order)
endif()
