// Chooses the pictures that show what errors look like, and writes them to files.
#include "Study/StudyInsets.h"

#include "Study/StudyRun.h"
#include "Text/AsideFile.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <tuple>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr int InsetWidth = 240;
constexpr int InsetHeight = 160;
constexpr size_t MostRows = 4;
constexpr size_t MostVariants = 3;

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

/** Recommended, in use, then of the rest those of the front first and the larger errors first; each once. */
std::vector<size_t> ChooseVariants(const FStudyResult& Result, const FStudyJob& Job)
{
	std::vector<size_t> Chosen;
	std::copy_if(Job.Variants.begin(), Job.Variants.end(), std::back_inserter(Chosen),
		[&](size_t Index) { return Result.Variants[Index].Competes(); });
	const auto GetOrder = [&](size_t Index)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		const bool bFront = Variant.ByTaps.bFront && !Variant.bPlainCode;
		return std::tuple(!Variant.bRecommended, !Variant.bCurrent, !bFront, -Variant.Error.Rms);
	};
	std::stable_sort(Chosen.begin(), Chosen.end(), [&](size_t A, size_t B) { return GetOrder(A) < GetOrder(B); });
	Chosen.resize(std::min(Chosen.size(), MostVariants));
	return Chosen;
}

/** The part around a place, no larger than the image; RGB. */
FImage CutOutAround(const FImage& Image, int CentreX, int CentreY)
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
				Part.Values.push_back(Image.Get(X, Y, Image.NumChannels >= 3 ? Channel : 0));
			}
		}
	}
	return Part;
}

/** Chooses the factor that makes linear values visible: all but the brightest twentieth come into range. At most 1. */
double ChooseExposure(FImage Part)
{
	const auto Bright = Part.Values.begin() + static_cast<std::ptrdiff_t>(Part.Values.size() * 19 / 20);
	std::nth_element(Part.Values.begin(), Bright, Part.Values.end());
	return *Bright > 1.0 && std::isfinite(*Bright) ? 1.0 / *Bright : 1.0;
}

/** As it is displayed. */
FImage Develop(FImage Part, EImageEncoding Encoding, double Exposure)
{
	for (double& Value : Part.Values)
	{
		Value = Encoding == EImageEncoding::Linear ? EncodeDisplay(Exposure * Value) : Value;
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

/** Writes the picture; its bytes. */
std::string WriteInset(const Files::path& File, const FImage& Image)
{
	WritePng(File.string(), Image);
	return ReadTextFile(File, "cannot be read", MaxBinaryBytes);
}

std::string DescribeError(const FStudyResult& Result, const FStudyVariant& Variant)
{
	return fmt::format(
		"{} {:.3g}, SSIM {:.4f}", Result.GetMetric(), GetMetric(Variant.Error, Result.GetMetric()), Variant.Error.Ssim);
}

FStudyInsetRow MakeInsetRow(FStudyRun& Run, const FStudyResult& Result, const FStudyJob& Job, const Files::path& Folder)
{
	const std::vector<size_t> Chosen = ChooseVariants(Result, Job);
	const FStudyPicture Reference = Run.RunReference(Job);
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
	FStudyInsetRow Row;
	Row.Title = Job.Case.Label.empty() ? Result.Name : Job.Case.Label;
	const double Exposure =
		Reference.Encoding == EImageEncoding::Linear ? ChooseExposure(CutOutAround(Exact, X, Y)) : 1.0;
	const auto Write = [&](const std::string& Name, const FImage& Image, EImageEncoding Encoding, FStudyInset& Inset)
	{
		const FImage Part = Develop(CutOutAround(Image, X, Y), Encoding, Exposure);
		Inset.Width = Part.Width;
		Inset.Height = Part.Height;
		return WriteInset(Folder / (MakeFileName(Row.Title) + "." + Name + ".png"), Part);
	};
	FStudyInset& First = Row.Insets.emplace_back();
	First.Title = "Reference";
	const std::array<int, 4> Region = Result.Study.Region.value_or(std::array<int, 4>());
	First.Subtitle = fmt::format("around ({}, {})", Region[0] + X, Region[1] + Y);
	First.Subtitle += Exposure < 1.0 ? fmt::format(", shown times {:.2g}", Exposure) : "";
	First.Png = Write("reference", Exact, Reference.Encoding, First);
	for (const size_t Index : Chosen)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		const FStudyPicture Picture = Run.RunVariant(Result, Variant);
		const std::string Name = MakeFileName(Variant.Label);
		FStudyInset& Inset = Row.Insets.emplace_back();
		Inset.Title = Variant.Label + (Variant.bRecommended ? " (recommended)" : Variant.bCurrent ? " (in use)" : "");
		Inset.Subtitle = DescribeError(Result, Variant);
		Inset.Png = Write(Name, Picture.Image, Picture.Encoding, Inset);
		const FImage Heat = MakeHeatMap(Picture.Image, Exact, Full, std::min(3, Exact.NumChannels));
		Inset.HeatPng = Write(Name + ".heat", Heat, EImageEncoding::Display, Inset);
		Inset.HeatTitle = fmt::format("its error, at most {:.3g}", Variant.Error.Max);
	}
	return Row;
}

} // namespace

std::vector<FStudyInsetRow> WriteStudyInsets(FStudyRun& Run, const FStudyResult& Result, const std::string& Folder)
{
	const Files::path Insets = Files::path(Folder) / "insets";
	std::error_code Error;
	Files::create_directory(Insets, Error);
	if (Error)
	{
		throw MakeWriteError(Insets.string(), Error.message());
	}
	return ToVector<FStudyInsetRow>(ChooseJobs(Result.Jobs.size()),
		[&](const size_t Job) { return MakeInsetRow(Run, Result, Result.Jobs[Job], Insets); });
}

} // namespace Drydock
