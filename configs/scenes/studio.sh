#!/bin/sh
# Makes the studio's files from shipped ones: studio.hdr, studio.tif, studio.dpx and ../textures/lens_dirt.jpg.
# It needs oiiotool (openimageio-tools) and is run in its own folder.
set -e
OCIO=$(mktemp --suffix .ocio)
export OCIO
trap 'rm "$OCIO"' EXIT
# Cineon's curve: 300 codes of 1023 a factor of ten, 685 is white, 95 is black.
cat > "$OCIO" <<'CONFIG'
ocio_profile_version: 2
roles: {default: linear}
file_rules: [!<Rule> {name: Default, colorspace: linear}]
displays: {none: [!<View> {name: none, colorspace: linear}]}
colorspaces:
  - !<ColorSpace> {name: linear}
  - !<ColorSpace>
    name: KodakLog
    from_scene_reference: !<LogAffineTransform> {base: 10, log_side_slope: 0.29325513, log_side_offset: 0.66959922, lin_side_slope: 0.98920252, lin_side_offset: 0.01079748}
CONFIG
oiiotool --nosoftwareattrib moving_camera.0003.exr --ch R,G,B --eraseattrib '.*' -o studio.hdr
oiiotool --nosoftwareattrib moving_camera.0006.exr --ch R,G,B --eraseattrib '.*' --attrib tiff:predictor 3 --compression zip \
  -o studio.tif
oiiotool --nosoftwareattrib toon_character.exr --ch R,G,B --resize 288x162 --clamp:min=0,0,0 --colorconvert linear KodakLog \
  --eraseattrib '.*' --iscolorspace KodakLog -d uint10 -o studio.dpx
oiiotool --nosoftwareattrib ../textures/lens_dirt.png --eraseattrib '.*' --iscolorspace sRGB --quality 80 -o ../textures/lens_dirt.jpg
