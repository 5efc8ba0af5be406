// Source: drydock.
#include "Study/StudyInsets.h"

#include "ConfigErrors.h"
#include "Study/StudyRun.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr int InsetWidth = 240;
constexpr int InsetHeight = 160;
constexpr size_t MostRows = 4;

bool Competes(const FStudyVariant& Variant)
{
	return Variant.bRan && Variant.Excluded.empty();
}

/** First, last and evenly between. */
std::vector<size_t> ChooseJobs(size_t NumJobs)
{
	std::vector<size_t> Jobs;
	const size_t Count = std::min(NumJobs, MostRows);
	for (size_t Index = 0; Index < Count; ++Index)
	{
		Jobs.push_back(Count == 1 ? 0 : Index * (NumJobs - 1) / (Count - 1));
	}
	return Jobs;
}

/** Recommended, in use, the one of the largest error on the front; each once. */
std::vector<size_t> ChooseVariants(const FStudyResult& Result, const FStudyJob& Job)
{
	std::vector<size_t> Chosen;
	const auto Add = [&](size_t Index)
	{
		if (std::find(Chosen.begin(), Chosen.end(), Index) == Chosen.end())
		{
			Chosen.push_back(Index);
		}
	};
	for (const size_t Index : Job.Variants)
	{
		if (Result.Variants[Index].bRecommended)
		{
			Add(Index);
		}
	}
	for (const size_t Index : Job.Variants)
	{
		if (Result.Variants[Index].bCurrent && Competes(Result.Variants[Index]))
		{
			Add(Index);
		}
	}
	const auto Cheaper = [&](size_t A, size_t B)
	{
		return Result.Variants[A].Error.Rms > Result.Variants[B].Error.Rms;
	};
	std::vector<size_t> Front;
	std::copy_if(Job.Variants.begin(), Job.Variants.end(), std::back_inserter(Front),
		[&](size_t Index)
		{
			return Competes(Result.Variants[Index]) && Result.Variants[Index].ByTaps.bFront &&
				   !Result.Variants[Index].bPlainCode;
		});
	std::stable_sort(Front.begin(), Front.end(), Cheaper);
	for (size_t Index = 0; Index < Front.size() && Chosen.size() < 2; ++Index)
	{
		Add(Front[Index]);
	}
	Chosen.resize(std::min<size_t>(Chosen.size(), 2));
	return Chosen;
}

/** The part around a place, no larger than the image; RGB as it is displayed. */
FImage CutOut(const FImage& Image, EImageEncoding Encoding, int CentreX, int CentreY)
{
	const int Width = std::min(InsetWidth, Image.Width);
	const int Height = std::min(InsetHeight, Image.Height);
	const int Left = std::clamp(CentreX - Width / 2, 0, Image.Width - Width);
	const int Top = std::clamp(CentreY - Height / 2, 0, Image.Height - Height);
	FImage Part{Width, Height, 3, {}};
	for (int Y = Top; Y < Top + Height; ++Y)
	{
		for (int X = Left; X < Left + Width; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Value = Image.Get(X, Y, Image.NumChannels >= 3 ? Channel : 0);
				Part.Values.push_back(Encoding == EImageEncoding::Linear ? EncodeDisplay(Value) : Value);
			}
		}
	}
	return Part;
}

/** Letters and digits of a name; others become _. */
std::string MakeFileName(const std::string& Name)
{
	std::string Text;
	for (const char Character : Name)
	{
		const bool bPlain = std::isalnum(static_cast<unsigned char>(Character)) || Character == '.' || Character == '-';
		Text += bPlain ? Character : '_';
	}
	return Text.empty() ? "picture" : Text;
}

FStudyInset WriteInset(
	const Files::path& File, const FImage& Image, const std::string& Title, const std::string& Subtitle)
{
	WritePng(File.string(), Image);
	std::ifstream Stream(File, std::ios::binary);
	return {Title, Subtitle, std::string(std::istreambuf_iterator<char>(Stream), {}), Image.Width, Image.Height};
}

std::string DescribeError(const FStudyResult& Result, const FStudyVariant& Variant)
{
	char Text[96];
	std::snprintf(Text, sizeof(Text), "%s %.3g, SSIM %.4f", Result.GetMetric().c_str(),
		GetMetric(Variant.Error, Result.GetMetric()), Variant.Error.Ssim);
	return Text;
}

FStudyInsetRow MakeRow(
	const FRunOptions& Options, const FStudyResult& Result, size_t JobIndex, const Files::path& Folder)
{
	const FStudyJob& Job = Result.Jobs[JobIndex];
	const std::vector<size_t> Chosen = ChooseVariants(Result, Job);
	const FStudyPicture Reference = RunStudyPicture(Options, Result, JobIndex, -1);
	const FImage& Exact = Reference.Image;
	double Full = 0.0;
	const FStudyVariant* Worst = nullptr;
	for (const size_t Index : Chosen)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		if (std::isfinite(Variant.Error.Max) && Variant.Error.Max > Full)
		{
			Full = Variant.Error.Max;
			Worst = &Variant;
		}
	}
	const int X = Worst != nullptr ? Worst->Error.MaxX : Exact.Width / 2;
	const int Y = Worst != nullptr ? Worst->Error.MaxY : Exact.Height / 2;
	const std::string Prefix = MakeFileName(Job.Case.Label.empty() ? Result.Name : Job.Case.Label) + ".";
	char Where[64];
	std::snprintf(Where, sizeof(Where), "around (%d, %d)", X, Y);
	FStudyInsetRow Row;
	Row.Title = Job.Case.Label.empty() ? Result.Name : Job.Case.Label;
	Row.Insets.push_back(
		WriteInset(Folder / (Prefix + "reference.png"), CutOut(Exact, Reference.Encoding, X, Y), "Reference", Where));
	for (const size_t Index : Chosen)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		const FStudyPicture Picture = RunStudyPicture(Options, Result, JobIndex, static_cast<int>(Index));
		const std::string Name = Prefix + MakeFileName(Variant.Label);
		const std::string Role = Variant.bRecommended ? " (recommended)" : Variant.bCurrent ? " (in use)" : "";
		Row.Insets.push_back(WriteInset(Folder / (Name + ".png"), CutOut(Picture.Image, Picture.Encoding, X, Y),
			Variant.Label + Role, DescribeError(Result, Variant)));
		const FImage Heat = MakeHeatMap(Picture.Image, Exact, Full, std::min(3, Exact.NumChannels));
		char Largest[64];
		std::snprintf(Largest, sizeof(Largest), "largest %.3g", Variant.Error.Max);
		Row.Insets.push_back(WriteInset(
			Folder / (Name + ".heat.png"), CutOut(Heat, EImageEncoding::Display, X, Y), "its error", Largest));
	}
	return Row;
}

} // namespace

std::vector<FStudyInsetRow> WriteStudyInsets(
	const FRunOptions& Options, const FStudyResult& Result, const std::string& Folder)
{
	const Files::path Insets = Files::path(Folder) / "insets";
	std::error_code Error;
	Files::remove_all(Insets, Error);
	Files::create_directories(Insets, Error);
	if (Error)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorFileNotWritten;
		Diagnostic.File = Insets.string();
		Diagnostic.Message = "the folder cannot be made: " + Error.message();
		throw FError(Diagnostic, ExitFiles);
	}
	std::vector<FStudyInsetRow> Rows;
	for (const size_t Job : ChooseJobs(Result.Jobs.size()))
	{
		Rows.push_back(MakeRow(Options, Result, Job, Insets));
	}
	return Rows;
}

} // namespace Drydock
