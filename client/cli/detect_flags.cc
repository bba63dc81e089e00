#include "client/cli/detect_flags.h"

#include <CLI/CLI.hpp>

namespace fovea::cli {
namespace {

CLI::Option* AddFlag(CLI::App& command, const char* flag, std::string& value, const char* type,
                     const char* help) {
  return command.add_option(flag, value, help)->type_name(type);
}

void AddTimeFlag(CLI::App& command, DetectFlags& flags) {
  command.add_option("--timeout", flags.timeout_s, "Longest wait for one answer")
      ->type_name("SECONDS")
      ->capture_default_str();
}

void AddCameraFlags(CLI::App& command, DetectFlags& flags) {
  AddFlag(
      command, "--intrinsics", flags.intrinsics, "FX,FY,CX,CY|FILE",
      "Of the colour camera in pixels, for example 525,525,319.5,239.5, or a calibration: ROS "
      "camera_info, YAML or JSON, or JSON with fx, fy, cx, cy, width, height; required unless the "
      "folder "
      "of --input holds intrinsics.json, camera_info.yaml or intrinsics.txt");
  AddFlag(
      command, "--distortion", flags.distortion, "MODEL=K1,K2,...",
      "Of the colour camera's lens, in place of the calibration's: plumb_bob (4 or 5 numbers, "
      "OpenCV's order), rational_polynomial (8) or equidistant (4, a fisheye); none = images are "
      "rectified");
  AddFlag(command, "--depth-intrinsics", flags.depth_intrinsics, "FX,FY,CX,CY|FILE",
          "Of the depth camera in pixels of the depth image, where depth is not registered to "
          "colour");
  AddFlag(command, "--color-from-depth", flags.color_from_depth, "X,Y,Z,QX,QY,QZ,QW",
          "With it: position (metres) and orientation (unit quaternion) of the depth camera in "
          "the colour camera's frame (x right, y down, z forward); both as fovea-capture kept them "
          "in a folder of its frames unless given");
  command
      .add_option(
          "--depth-unit", flags.depth_unit_m,
          "Metres per unit of the depth image; 0.001 unless given, 0.0002 in TUM's folders, "
          "what fovea-capture kept in a folder of its frames")
      ->type_name("METRES");
  AddFlag(command, "--gravity", flags.gravity, "X,Y,Z",
          "Unit vector that points down in the camera frame (x right, y down, z forward); "
          "estimated from the scene where absent");
  AddFlag(command, "--camera-pose", flags.camera_pose, "X,Y,Z,QX,QY,QZ,QW",
          "Position (metres) and orientation (unit quaternion) of the camera in a frame of your "
          "choice; objects then have their pose there, too");
}

void AddOutputFlags(CLI::App& command, DetectFlags& flags) {
  command
      .add_option("--show", flags.show,
                  "What else overlays show, with commas between: seeds, saliency, rejected (what "
                  "was considered and is not reported), grasps (all, not the likeliest alone), "
                  "collisions (the collision primitives)")
      ->delimiter(',')
      ->type_name("WHAT")
      ->check(CLI::IsMember({"seeds", "saliency", "rejected", "grasps", "collisions"}))
      ->allow_extra_args(false);
  command.add_flag("--no-masks", flags.no_masks, "Leave masks out of JSON, and NAME.png");
}

void AddFrameFlags(CLI::App& command, DetectFlags& flags) {
  const char* group = "One frame";
  Outputs& outputs = flags.outputs;
  AddFlag(command, "--color", flags.color, "FILE", "Colour image, PNG or JPEG")->group(group);
  AddFlag(command, "--depth", flags.depth, "FILE",
          "16-bit PNG, 0 = not measured; registered to colour unless --color-from-depth is given")
      ->group(group);
  AddFlag(command, "--id", flags.id, "NAME", "Name of the frame; else that of the colour file")
      ->group(group);
  AddFlag(command, "--labels", outputs.labels, "FILE",
          "Write the label image: 0 = background, k = object k; PNG")
      ->group(group);
  AddFlag(command, "--json", outputs.json, "FILE",
          "Write the whole answer; - = to standard output, one line a frame, also of a folder")
      ->group(group);
  AddFlag(command, "--overlay", outputs.overlay, "FILE", "Write a picture of what was found")
      ->group(group);
  AddFlag(
      command, "--cloud", outputs.cloud, "FILE.ply|FILE.pcd",
      "Write the coloured point cloud with solids and grippers as dots; of a folder, ply or pcd "
      "alone: NAME.ply or NAME.pcd of each frame")
      ->group(group);
  AddFlag(command, "--height-map", outputs.height_map, "FILE",
          "Write a height map as a picture from above, unknown cells hatched; of a folder, jpg "
          "alone: NAME_height.jpg of each frame. --height-map-cell says how fine")
      ->group(group);
  AddFlag(command, "--saliency", outputs.saliency_prefix, "PREFIX",
          "Write the saliency maps to PREFIX_color.png and PREFIX_depth.png")
      ->group(group);
  AddFlag(command, "--explain", outputs.steps, "FOLDER",
          "Write a picture of every step, from depth and saliency over seeds and hypotheses to the "
          "objects, and index.html, which shows them; made where it is missing; not with "
          "--time-budget")
      ->group(group);
}

void AddFolderFlags(CLI::App& command, DetectFlags& flags) {
  const char* group = "A folder of frames, a bag or a bundle";
  CLI::Option* const input =
      AddFlag(
          command, "--input", flags.input, "FOLDER|FILE.mcap|FILE.db3|FILE.zip",
          "Every NAME_color.png (or .jpg) with its NAME_depth.png; or TUM RGB-D (rgb.txt and "
          "depth.txt); or folders rgb (or color) and depth with images of the same names or named "
          "by their times; or a ROS 2 bag (its folder, or a file of MCAP or SQLite) with images; "
          "or a bundle that fovea-observer "
          "saved, whose frames are sent as they were, with the options of then, which --set "
          "changes, and whose answers are compared")
          ->group(group);
  const auto of_input = [&](CLI::Option* option) { return option->group(group)->needs(input); };
  of_input(AddFlag(command, "--color-topic", flags.color_topic, "TOPIC",
                   "Of a bag, where several can be meant"));
  of_input(AddFlag(command, "--depth-topic", flags.depth_topic, "TOPIC", "The same for depth"));
  AddFlag(
      command, "--output", flags.output, "FOLDER",
      "For NAME.png (labels), NAME.json and NAME_overlay.jpg, which are overwritten; made where "
      "it is missing; not the folder of --input")
      ->group(group);
  of_input(command
               .add_option("--jobs", flags.jobs,
                           "Frames in flight at once, 1 to 64; else 4, or as many as the server "
                           "takes of one robot where that is less")
               ->type_name("N")
               ->check(CLI::Range(1, 64)));
  of_input(command.add_flag("--no-overlay", flags.no_overlay, "Write no NAME_overlay.jpg"));
  of_input(command.add_flag("--resume", flags.resume,
                            "Leave out frames whose files are there and not older"));
}

}  // namespace

void AddDetectFlags(CLI::App& command, DetectFlags& flags) {
  AddConnectionFlags(command, flags.connection);
  AddTimeFlag(command, flags);
  AddCameraFlags(command, flags);
  AddQuestionFlags(command, flags.question, "Detection");
  AddOutputFlags(command, flags);
  AddFrameFlags(command, flags);
  AddFolderFlags(command, flags);
}

OverlayExtras ExtrasOf(const DetectFlags& flags) {
  OverlayExtras extras;
  for (const std::string& name : flags.show) {
    extras.seeds |= name == "seeds";
    extras.saliency |= name == "saliency";
    extras.rejected |= name == "rejected";
    extras.grasps |= name == "grasps";
    extras.collisions |= name == "collisions";
  }
  return extras;
}

}  // namespace fovea::cli
