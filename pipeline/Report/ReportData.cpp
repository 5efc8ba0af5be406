// Gathers what a report says, and writes it as JSON.
#include "Report/ReportData.h"

#include "PostProcessSettingsReflection.h"
#include "Picture/Preview.h"
#include "Picture/TextureImage.h"
#include "Report/ReportPage.h"
#include "Report/ReportPicture.h"
#include "Run/GraphJson.h"
#include "Run/RunDifference.h"
#include "Run/RunDump.h"
#include "Shader.h"
#include "ShaderBinding.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <set>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

bool IsJson(const std::string& Text)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	ParseJson(Text, "", Ignored, bSyntaxError);
	return !Text.empty() && !bSyntaxError;
}

class FPictures
{
public:
	FPictures(FJsonWriter& InWriter, const FReportInputs& InInputs)
		: Writer(InWriter)
		, Inputs(InInputs)
	{
	}

	void Write()
	{
		Writer.Key("pictures").BeginArray();
		if (Inputs.bLarge)
		{
			WriteLarge();
		}
		const size_t NumLeftOut = WriteThumbnails();
		if (!Inputs.Before.FinalPng.empty())
		{
			WriteReportPicture(Writer, {.Id = "previous",
										   .Role = "previous",
										   .Label = "Final picture of the run before",
										   .Channels = {"R", "G", "B"},
										   .Png = Inputs.Before.FinalPng});
		}
		Writer.EndArray();
		Writer.Member("thumbnailsLeftOut", static_cast<uint64_t>(NumLeftOut));
	}

private:
	void WriteLarge()
	{
		const FRunResult& Result = Inputs.Result;
		// The page takes codes for those of an sRGB display; of others it has the picture that the PNG makes of them.
		const bool bSrgb = Result.OutputDevice == EDisplayOutputFormat::SDR_sRGB ||
						   Result.OutputDevice == EDisplayOutputFormat::SDR_ExplicitGammaMapping;
		WriteFrame({.Id = "final",
					   .Role = "final",
					   .Label = bSrgb ? "Final picture" : "Final picture, as an sRGB display shows it",
					   .bPack = Inputs.bFull && bSrgb},
			Result.Final.Take(3), "final.png",
			[&](const std::string& File) { WriteDisplayPng(File, Result.Final, Result.OutputDevice); });
		const FPicture Scene = Result.SceneLinear.Take(3);
		WriteFrame(
			{.Id = "scene", .Role = "scene", .Label = "Scene, linear, before the tonemapper", .bPack = Inputs.bFull},
			Scene, "", [&](const std::string& File) { WritePreviewPng(File, Scene); });
		for (const FRunDump& Dump : Result.Dumps)
		{
			WriteDump(Dump);
		}
	}

	/** Bytes of the run's own file; where there is none, of one made for the purpose. */
	std::string ReadPng(const std::string& Own, const std::function<void(const std::string& File)>& Make) const
	{
		const Files::path Path = Files::path(Inputs.Folder) / Own;
		if (!Own.empty() && Files::exists(Path))
		{
			return ReadTextFile(Path, "cannot be read", MaxBinaryBytes);
		}
		const Files::path Scratch = Files::path(Inputs.Folder) / "report.part.png";
		Make(Scratch.string());
		const std::string Bytes = ReadTextFile(Scratch, "cannot be read", MaxBinaryBytes);
		Files::remove(Scratch);
		return Bytes;
	}

	void WriteFrame(FReportPicture Picture, const FPicture& Values, const std::string& Own,
		const std::function<void(const std::string& File)>& Make)
	{
		Picture.Extent = {Values.Width, Values.Height};
		Picture.Size = Picture.Extent;
		Picture.Channels = {"R", "G", "B"};
		Picture.Values = &Values;
		Picture.Encoding = Own.empty() ? GetPreviewEncoding(Values) : EReportEncoding::Display;
		Picture.Png = ReadPng(Own, Make);
		WriteReportPicture(Writer, Picture);
	}

	static EReportEncoding GetPreviewEncoding(const FPicture& Picture)
	{
		return MeasurePicture(Picture).IsInDisplayRange() ? EReportEncoding::Srgb : EReportEncoding::Compressed;
	}

	void WriteDump(const FRunDump& Dump)
	{
		const FPicture Part = Dump.Image.Crop(Dump.Window);
		const std::string File = GetDumpFileName(Dump);
		WriteReportPicture(Writer, {.Id = File,
									   .Role = "dump",
									   .Label = GetShortPassName(Dump.Pass) + " \u2192 " + Dump.Resource +
												(Dump.Mip >= 0 ? " mip " + std::to_string(Dump.Mip) : ""),
									   .Pass = Dump.PassIndex,
									   .Resource = Dump.Resource,
									   .Mip = Dump.Mip,
									   .Extent = {Dump.Image.Width, Dump.Image.Height},
									   .Corner = {Dump.Window.Min.X, Dump.Window.Min.Y},
									   .Size = {Part.Width, Part.Height},
									   .Channels = Dump.Channels,
									   .Encoding = GetPreviewEncoding(Part),
									   .Png = ReadPng("passes/" + File + ".png",
										   [&](const std::string& Path) { WritePreviewPng(Path, Part); }),
									   .Values = &Part,
									   .bPack = Inputs.bFull});
	}

	/** Writes every thumbnail, or every second, fourth, ... while they weigh too much. Returns how many it left out. */
	size_t WriteThumbnails()
	{
		std::vector<FReportPicture> All;
		size_t Bytes = 0;
		for (const FRunPass& Pass : Inputs.Result.Passes)
		{
			for (const FRunThumbnail& Thumbnail : Pass.Thumbnails)
			{
				All.push_back(MakeThumbnail(Pass, Thumbnail));
				Bytes += All.back().Png.size();
			}
		}
		size_t Step = 1;
		while (Bytes / Step > Inputs.MaxThumbnailBytes)
		{
			Step *= 2;
		}
		for (size_t Index = 0; Index < All.size(); Index += Step)
		{
			WriteReportPicture(Writer, All[Index]);
		}
		return All.size() - (All.size() + Step - 1) / Step;
	}

	FReportPicture MakeThumbnail(const FRunPass& Pass, const FRunThumbnail& Thumbnail) const
	{
		const std::string& Name = Inputs.Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name;
		bool bDisplayRange = true;
		for (const double Value : Thumbnail.Image.Values)
		{
			bDisplayRange = bDisplayRange && Value >= 0.0 && Value <= 1.0;
		}
		return {.Id = "thumbnail." + std::to_string(Pass.Index) + "." + Thumbnail.Resource,
			.Role = "thumbnail",
			.Label = GetShortPassName(Name) + " \u2192 " + Thumbnail.Resource,
			.Pass = Pass.Index,
			.Resource = Thumbnail.Resource,
			.Extent = {Thumbnail.Extent.X, Thumbnail.Extent.Y},
			.Size = {Thumbnail.Image.Width, Thumbnail.Image.Height},
			.Channels = GetChannelNames(Thumbnail.Image.NumChannels),
			.Encoding = bDisplayRange ? EReportEncoding::Srgb : EReportEncoding::Compressed,
			.Png = ReadPng("", [&](const std::string& Path) { WritePreviewPng(Path, Thumbnail.Image); })};
	}

	FJsonWriter& Writer;
	const FReportInputs& Inputs;
};

/** The class of that name; null: there is none, as for a lambda's pass. */
const FShaderType* FindShaderType(const std::string& Name)
{
	const FShaderType* Found = nullptr;
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			if (Type.GetName() == Name)
			{
				Found = &Type;
			}
		});
	return Found;
}

/** Defines of the permutations of the class that were asked for so far; where there are several, one of them ran. */
void WritePermutations(FJsonWriter& Writer, const FShaderType& Type)
{
	std::vector<int32> Ids;
	Type.ForEachShader([&](FShader& Shader) { Ids.push_back(Shader.GetPermutationId()); });
	Writer.Objects("permutations", Ids,
		[&](const int32 Id)
		{
			const FShaderCompilerEnvironment Environment = Type.GetCompilationEnvironment(Id);
			for (const auto& [Name, Value] : Environment.GetDefines())
			{
				Writer.Member(Name, Value);
			}
		});
}

/** Parameters whose resources the class uses in any permutation. Nothing where no struct was bound. */
void WriteBound(FJsonWriter& Writer, const FShaderType& Type)
{
	std::set<std::string> Bound;
	Type.ForEachShader(
		[&](FShader& Shader)
		{
			const std::vector<std::string> Names = ListBoundResources(Shader);
			Bound.insert(Names.begin(), Names.end());
		});
	if (!Bound.empty())
	{
		Writer.Member("bound", std::vector<std::string>(Bound.begin(), Bound.end()));
	}
}

/** Writes what the graph and the run leave out about passes that ran. */
void WritePasses(FJsonWriter& Writer, const FRunResult& Result)
{
	Writer.Array("passes", Result.Passes,
		[&](const FRunPass& Pass)
		{
			const FRDGCompiledPass& Compiled = Result.Graph.Passes[static_cast<size_t>(Pass.Index)];
			const FShaderType* const Type =
				FindShaderType(Compiled.Shader.empty() ? Pass.Counters.Shader : Compiled.Shader);
			Writer.BeginObject();
			Writer.Members({{"index", Pass.Index}, {"shaderFile", Type != nullptr ? Type->GetShaderFilename() : ""}});
			if (Type != nullptr)
			{
				WritePermutations(Writer, *Type);
				WriteBound(Writer, *Type);
			}
			Writer.Key("parameters").BeginArray();
			const auto Values = Result.PassValues.find(Pass.Index);
			for (size_t i = 0; Values != Result.PassValues.end() && i < Values->second.size(); ++i)
			{
				const FPassValue& Value = Values->second[i];
				Writer.Object({{"name", Value.Name}, {"type", Value.Type}, {"value", Value.Value}});
			}
			Writer.EndArray();
			Writer.EndObject();
		});
}

void WriteSettings(FJsonWriter& Writer, const FReportInputs& Inputs)
{
	Writer.Array("settings", GetSettingFields(),
		[&](const FSettingField& Field)
		{
			const std::string Value = SettingToJson(Field, Field.Get(Inputs.Result.Settings));
			const std::string Default = SettingToJson(Field, Field.Default);
			if (Value == Default || (Inputs.Touched && Inputs.Touched->count(Field.Name) == 0))
			{
				return;
			}
			const FEffect* const Owner = FindSettingOwner(Field.Name);
			Writer.BeginObject(true);
			Writer.Member("name", Field.Name);
			Writer.Key("value").Raw(Value);
			Writer.Key("default").Raw(Default);
			Writer.Members({{"unit", Field.Unit}, {"category", Field.Category}, {"doc", Field.Doc},
				{"effect", Owner != nullptr ? *Owner->Name : ""}, {"unread", GetSettingNotBuiltReason(Field.Name)}});
			Writer.EndObject();
		});
}

void WriteNonFinite(FJsonWriter& Writer, const FNonFiniteSpread& Spread)
{
	Writer.Key("nonFinite").BeginObject();
	Writer.Array("passes", Spread.Passes,
		[&](const FNonFiniteFootprint& Pass) {
			Writer.Object({{"pass", Pass.Pass}, {"pixels", Pass.Pixels}, {"of", Pass.NumPixels}});
		});
	if (Spread.Final)
	{
		Writer.Key("final").Object({{"pixels", Spread.Final->NumPixels}, {"changed", Spread.Final->Changed},
			{"white", Spread.Final->White}, {"notFinite", Spread.Final->NotFinite}});
	}
	Writer.EndObject();
}

void WriteBefore(FJsonWriter& Writer, const FReportInputs& Inputs)
{
	const FReportBefore& Before = Inputs.Before;
	if (Before.RunJson.empty())
	{
		return;
	}
	Writer.Key("previous").BeginObject();
	Writer.Member("written", Before.When);
	WriteRunDifferences(Writer, "differences", CompareRuns(Before.RunJson, Inputs.Result.RunJson));
	Writer.Key("run").Raw(Before.RunJson);
	Writer.RawMember("timing", Before.TimingJson);
	Writer.EndObject();
}

} // namespace

FReportBefore ReadReportBefore(const std::string& Folder)
{
	const auto Read = [&](const char* Name)
	{
		return TryReadTextFile((Files::path(Folder) / Name).string(), MaxBinaryBytes).value_or("");
	};
	FReportBefore Before;
	Before.RunJson = Read("run.json");
	if (!IsJson(Before.RunJson))
	{
		return {};
	}
	Before.TimingJson = Read("timing.json");
	if (!IsJson(Before.TimingJson))
	{
		Before.TimingJson.clear();
	}
	Before.FinalPng = Read("final.png");
	std::error_code Error;
	const auto Time = Files::last_write_time(Files::path(Folder) / "run.json", Error);
	if (!Error)
	{
		Before.When = FormatReportTime(std::chrono::system_clock::to_time_t(std::chrono::file_clock::to_sys(Time)));
	}
	return Before;
}

std::string MakeReportData(const FReportInputs& Inputs)
{
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "run"}, {"name", Inputs.Name},
		{"written", Inputs.When.empty() ? FormatReportTime(std::time(nullptr)) : Inputs.When}});
	Writer.RawMember("run", Inputs.Result.RunJson);
	Writer.RawMember("timing", Inputs.TimingJson);
	Writer.RawMember("graph", MakeGraphJson(Inputs.Result.Graph));
	Writer.RawMember("explain", Inputs.ExplainJson);
	Writer.RawMember("blend", Inputs.BlendJson);
	Writer.RawMember("walk", Inputs.WalkJson);
	WritePasses(Writer, Inputs.Result);
	WriteSettings(Writer, Inputs);
	WriteNonFinite(Writer, Inputs.Result.NonFinite);
	WriteBefore(Writer, Inputs);
	FPictures(Writer, Inputs).Write();
	return Writer.GetText();
}

} // namespace Drydock
