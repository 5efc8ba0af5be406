// Makes the pictures of a comparison, and writes its page's data.
#include "Report/DiffPage.h"

#include "Report/ReportData.h"
#include "Report/ReportPng.h"
#include "Text/JsonWriter.h"
#include "Text/Version.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

EReportEncoding GetEncoding(const FComparedImage& Image)
{
	const std::vector<double>& Values = Image.Image.Values;
	const auto IsShown = [](double Value)
	{
		return Value >= 0.0 && Value <= 1.0;
	};
	return Image.Encoding == EImageEncoding::Display            ? EReportEncoding::Display
		   : std::all_of(Values.begin(), Values.end(), IsShown) ? EReportEncoding::Srgb
																: EReportEncoding::Compressed;
}

void WriteSide(FJsonWriter& Writer, const char* Key, const std::string& Path)
{
	Writer.Key(Key).BeginObject();
	Writer.Member("path", Path);
	const FReportBefore Run = ReadReportBefore(Path);
	Writer.RawMember("run", Run.RunJson);
	Writer.RawMember("timing", Run.TimingJson);
	Writer.EndObject();
}

/** "toon_bloom" of out/toon_bloom/, "final.png" of a/final.png. */
std::string GetName(const std::string& Path)
{
	const Files::path Clean = Files::path(Path).lexically_normal();
	return (Clean.has_filename() ? Clean.filename() : Clean.parent_path().filename()).string();
}

} // namespace

void FDiffPage::AddPicture(const std::string& Name, const char* Role, const FComparedImage& Image, std::string Png)
{
	FReportPicture Picture;
	Picture.Id = std::string(Role) + ": " + Name;
	Picture.Role = Role;
	Picture.Label = Name;
	Picture.Resource = Name;
	Picture.Extent = {Image.Window.FullWidth, Image.Window.FullHeight};
	Picture.Corner = {Image.Window.X, Image.Window.Y};
	Picture.Size = {Image.Image.Width, Image.Image.Height};
	Picture.Channels = Image.Channels;
	Picture.Encoding = GetEncoding(Image);
	Picture.Png = std::move(Png);
	Groups.back().push_back(Pictures.size());
	Pictures.push_back(std::move(Picture));
}

void FDiffPage::AddPair(
	const std::string& Name, const FComparedImage& A, const FComparedImage& B, const FImageError& Error)
{
	const bool bDisplay = A.Encoding == EImageEncoding::Display;
	Groups.emplace_back();
	AddPicture(Name, "a", A, MakePng(A.Image, bDisplay));
	if (Error.Max == 0.0)
	{
		return; // B is the same picture
	}
	AddPicture(Name, "b", B, MakePng(B.Image, bDisplay));
	FComparedImage Map = A;
	Map.Image = MakeHeatMap(A.Image, B.Image, std::isfinite(Error.Max) ? Error.Max : Error.Peak);
	Map.Channels = {"R", "G", "B"};
	Map.Encoding = EImageEncoding::Display;
	AddPicture(Name, "error", Map, MakePng(Map.Image, true));
}

std::string FDiffPage::MakeData(
	const std::string& A, const std::string& B, const std::string& DiffJson, const std::string& When)
{
	FitPictures(Pictures, Groups, MaxPagePictureBytes);
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "diff"},
		{"name", GetName(A) + " against " + GetName(B)}, {"version", GetVersion()}, {"written", When}});
	Writer.Key("diff").Raw(DiffJson);
	WriteSide(Writer, "a", A);
	WriteSide(Writer, "b", B);
	WriteReportPictures(Writer, Pictures);
	return Writer.GetText();
}

} // namespace Drydock
