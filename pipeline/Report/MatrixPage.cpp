// Puts a matrix and its pictures into one JSON.
#include "Report/MatrixPage.h"

#include "Picture/PictureFile.h"
#include "Report/ReportPng.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/Version.h"

#include <numeric>

namespace Drydock
{

std::string MakeMatrixPageData(const FMatrixPageInputs& Inputs, const std::string& When)
{
	std::vector<FReportPicture> Pictures;
	for (const auto& [Engine, File] : Inputs.Pictures)
	{
		const FImage Image = ReadPicture(File);
		FReportPicture Picture;
		Picture.Id = Engine;
		Picture.Role = "version";
		Picture.Label = "Engine " + Engine;
		Picture.Extent = Picture.Size = {Image.Width, Image.Height};
		Picture.Channels = {"R", "G", "B"};
		Picture.Png = ReadTextFile(File, "cannot be read", MaxBinaryBytes);
		Pictures.push_back(std::move(Picture));
	}
	std::vector<size_t> All(Pictures.size());
	std::iota(All.begin(), All.end(), 0);
	FitPictures(Pictures, {All}, MaxPagePictureBytes);

	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "matrix"}, {"name", Inputs.Name},
		{"version", GetVersion()}, {"written", When}});
	Writer.Key("matrix").Raw(Inputs.MatrixJson);
	WriteReportPictures(Writer, Pictures);
	return Writer.GetText();
}

} // namespace Drydock
