# Completion of the tools' options for bash, by what their help has.
_acmap()
{
  local word=${COMP_WORDS[COMP_CWORD]}
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$("$1" --help all 2>/dev/null |
      grep -oE -- '--[a-z0-9][a-z0-9-]*' | sort -u)" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _acmap pcl_active_stereo pcl_camera_grabber pcl_cloud_info \
  pcl_compact_mapping pcl_compact_viewer pcl_dewall_surface pcl_digiclops_grabber \
  pcl_entropy_rectification pcl_line_pattern pcl_plane_extraction pcl_plane_texturing \
  pcl_rgbd_import pcl_rig_calibration pcl_simulated_rig pcl_visual_egomotion
