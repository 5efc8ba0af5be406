// PNG files of pictures to look at: for a final picture the colours that an sRGB display can show, for any other values
// a preview. Source of the transfer functions: SMPTE ST 2084, ITU-R BT.709, BT.2020, IEC 61966-2-1.
#pragma once

#include "Picture/Picture.h"
#include "Tonemap/TonemapOutputDevice.h"

#include <array>

namespace Drydock
{

/** sRGB code values of a colour that is encoded for a device. sRGB and powers: as they are. Rec.709: decoded. Light
 * above 100 nits (ST 2084 and scRGB) or above 1 (linear) is cut off, so is what Rec.709 cannot show. */
DRYDOCK_API std::array<double, 3> MakeDisplayColor(
	const std::array<double, 3>& Color, EDisplayOutputFormat OutputDevice);

/** A row of a final picture in 8 bits for an sRGB display: red, green and blue to every Step bytes from Bytes on, and
 * anything between them. Row: Width colours, NumChannels numbers each. */
DRYDOCK_API void MakeDisplayRow(
	const float* Row, int Width, int NumChannels, EDisplayOutputFormat OutputDevice, uint8_t* Bytes, int Step);

/** Red, green and blue of a final picture for an sRGB display. Throws FError (exit code 3) when it cannot be written.
 */
DRYDOCK_API void WriteDisplayPng(const std::string& Path, const FPicture& Picture, EDisplayOutputFormat OutputDevice);

/** Writes a picture to look at: values as they are where all lie in 0..1, else compressed by x / (1 + x); then sRGB. No
 * alpha; two channels are red and green. Throws as above. */
DRYDOCK_API void WritePreviewPng(const std::string& Path, const FPicture& Picture);
DRYDOCK_API void WritePreviewPng(const std::string& Path, const FImage& Image);

} // namespace Drydock
