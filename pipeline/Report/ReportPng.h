// Pictures of a page as PNG bytes, made as small as the page may hold.
#pragma once

#include "Picture/ImageFile.h"
#include "Report/ReportPicture.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** The limit of pictures as PNG, so that a page with them in base64 stays under 5 MB: 3.3 MB. */
constexpr size_t MaxPagePictureBytes = 3'300'000;

/** The bytes of what Write writes to the file that it is given. Throws FError (exit code 3). */
DRYDOCK_API std::string MakePng(const std::function<void(const std::string& File)>& Write);

/** The PNG of a display-encoded picture, or of linear values as WritePreviewPng shows them. Throws FError (exit code
 * 3). */
DRYDOCK_API std::string MakePng(const FImage& Image, bool bDisplay);

/** A display-encoded PNG at half its width and height. Throws FError (exit code 3). */
DRYDOCK_API std::string HalvePng(const std::string& Png);

/** Halves PNG files until all together weigh no more than MaxBytes, or none is 256 pixels wide any more: each time
 * those of the group that weighs most, so that pictures which are looked at beside each other keep one scale. Groups:
 * which of Pictures belong together, by index. Throws FError (exit code 3). */
DRYDOCK_API void FitPictures(
	std::vector<FReportPicture>& Pictures, const std::vector<std::vector<size_t>>& Groups, size_t MaxBytes);

} // namespace Drydock
