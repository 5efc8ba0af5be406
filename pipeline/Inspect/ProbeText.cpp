// Writes a probe, for a person and for programs.
#include "Inspect/ProbeCapture.h"

#include "OperationText.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <functional>
#include <ranges>

namespace Drydock
{

namespace
{

constexpr size_t MaxProbedTexels = 6; // of a texture; of more the heaviest
constexpr size_t MaxProbedShared = 32;

std::string FormatValue(const std::array<double, 4>& Value, int NumChannels)
{
	std::string Text;
	for (int c = 0; c < NumChannels; ++c)
	{
		Text += (c ? ", " : "") + FormatReal(Value[size_t(c)]);
	}
	return NumChannels > 1 ? "(" + Text + ")" : Text;
}

std::string FormatTexel(const std::string& Name, const FProbeTexel& Texel, const std::string& Size)
{
	return fmt::format("{} {},{}{} = {} ({})", Name, Texel.X, Texel.Y, Size,
		FormatValue(Texel.Value, Texel.NumChannels), Texel.Format);
}

/** Those that the shader read, with their values; before them the texel at the pixel. */
std::string FormatReads(const FProbeRead& Read, const FProbeRequest& Request)
{
	std::vector<FFootprintTexel> Texels = Read.Texels;
	std::ranges::stable_sort(Texels, std::greater(), &FFootprintTexel::Weight);
	const std::string Size =
		Read.Size == Request.Frame ? std::string() : fmt::format(" of {} x {}", Read.Size[0], Read.Size[1]);
	std::string Text =
		Read.AtPixel ? FormatTexel(Read.Texture, *Read.AtPixel, Size) + " at the pixel, read: " : Read.Texture + ": ";
	const int NumChannels = Read.AtPixel ? Read.AtPixel->NumChannels : 4;
	for (size_t i = 0; i < Texels.size() && i < MaxProbedTexels; ++i)
	{
		const FFootprintTexel& Texel = Texels[i];
		const std::string At = Texel.X < 0 ? std::string("border") : fmt::format("{},{}", Texel.X, Texel.Y);
		Text += fmt::format("{}{}{} = {}", i ? ", " : "", At,
			Texel.Weight == 1 ? "" : fmt::format(" x {:.4g}", Texel.Weight),
			FormatValue({Texel.Value[0], Texel.Value[1], Texel.Value[2], Texel.Value[3]}, NumChannels));
	}
	return Text + (Texels.size() > MaxProbedTexels ? fmt::format(", {} more", Texels.size() - MaxProbedTexels)
												   : std::string());
}

/** "12,3", "12,3,1" */
std::string FormatThread(const std::array<int32_t, 3>& Id)
{
	return fmt::format("{},{}{}", Id[0], Id[1], Id[2] ? fmt::format(",{}", Id[2]) : std::string());
}

std::string FormatShared(const FProbeShared& Shared)
{
	const std::string Value = JoinText(Shared.Value, ", ", [](const double Number) { return FormatReal(Number); });
	return Shared.Name + " = " + (Shared.Value.size() > 1 ? "(" + Value + ")" : Value) +
		   (Shared.WriterLine
				   ? fmt::format(", put there by thread {} in line {}", FormatThread(Shared.Writer), Shared.WriterLine)
				   : std::string(", which no thread wrote"));
}

std::string FormatWrite(const FProbeWrite& Write)
{
	return FormatTexel(Write.Target, Write, "");
}

void WriteTexel(FJsonWriter& Writer, const FProbeTexel& Texel)
{
	Writer.Members({{"format", Texel.Format}, {"x", Texel.X}, {"y", Texel.Y},
		{"value", Texel.Value | std::views::take(Texel.NumChannels)}});
}

void WritePass(FJsonWriter& Writer, const FProbePass& Pass)
{
	Writer.BeginObject();
	Writer.Members({{"pass", Pass.Pass}, {"shader", Pass.Shader}, {"drawn", Pass.bDrawn}});
	Writer.Objects("threads", Pass.Threads,
		[&](const FTexelWriter& Thread)
		{
			Writer.Members({{"texture", Thread.Texture}, {"x", Thread.Texel[0]}, {"y", Thread.Texel[1]},
				{"thread", Thread.Thread}});
		});
	Writer.Objects("groupshared", Pass.Shared,
		[&](const FProbeShared& Shared)
		{
			Writer.Members({{"name", Shared.Name}, {"value", Shared.Value}, {"writer", Shared.Writer},
				{"line", Shared.WriterLine}});
		});
	Writer.Array("reads", Pass.Reads,
		[&](const FProbeRead& Read)
		{
			Writer.BeginObject();
			Writer.Member("texture", Read.Texture);
			if (Read.AtPixel)
			{
				Writer.Key("atPixel").BeginObject(true);
				Writer.Members({{"width", Read.Size[0]}, {"height", Read.Size[1]}});
				WriteTexel(Writer, *Read.AtPixel);
				Writer.EndObject();
			}
			Writer.Member("reads", Read.NumReads);
			Writer.Array("texels", Read.Texels,
				[&](const FFootprintTexel& Texel)
				{
					Writer.Object({{"x", Texel.X}, {"y", Texel.Y}, {"z", Texel.Z}, {"mip", Texel.Mip},
						{"weight", Texel.Weight}, {"value", Texel.Value}});
				});
			Writer.EndObject();
		});
	Writer.Objects("writes", Pass.Writes,
		[&](const FProbeWrite& Write)
		{
			Writer.Member("target", Write.Target);
			WriteTexel(Writer, Write);
		});
	Writer.EndObject();
}

} // namespace

std::string MakeProbeText(
	const std::vector<FProbePass>& Passes, const std::vector<FProbePass>& Against, const FProbeRequest& Request)
{
	const bool bCompare = !Against.empty();
	const std::optional<FProbeDifference> Difference =
		bCompare ? FindDifference(Passes, Against) : std::optional<FProbeDifference>();
	const FProbeDifference Parted = Difference.value_or(FProbeDifference{Passes.size()}); // behind the last: nowhere
	std::string Text = fmt::format("pixel {},{}", Request.X, Request.Y);
	Text +=
		Request.Width * Request.Height > 1 ? fmt::format(", {} x {}", Request.Width, Request.Height) : std::string();
	Text += Request.Frame[0] ? fmt::format(" of {} x {}\n", Request.Frame[0], Request.Frame[1]) : std::string("\n");
	Text += "A texture of another size has the texel that covers the pixel's centre.\n";
	for (size_t Index = 0; Index < Passes.size(); ++Index)
	{
		const FProbePass& Pass = Passes[Index];
		Text += fmt::format("\n{}  ({})\n", Pass.Pass, Pass.Shader);
		Text += Pass.bDrawn ? "" : "   does not draw here\n";
		for (const FTexelWriter& Writer : Pass.Threads)
		{
			Text += fmt::format("   thread {} stored to {} {},{}\n", FormatThread(Writer.Thread), Writer.Texture,
				Writer.Texel[0], Writer.Texel[1]);
		}
		for (size_t Index = 0; Index < Pass.Shared.size() && Index < MaxProbedShared; ++Index)
		{
			Text += "   reads " + FormatShared(Pass.Shared[Index]) + "\n";
		}
		Text += Pass.Shared.size() > MaxProbedShared
					? fmt::format("   reads {} more of groupshared memory\n", Pass.Shared.size() - MaxProbedShared)
					: std::string();
		for (const FProbeRead& Read : Pass.Reads)
		{
			Text += fmt::format("   reads {}\n", FormatReads(Read, Request));
		}
		for (size_t Write = 0; Write < Pass.Writes.size(); ++Write)
		{
			Text += "   " + FormatWrite(Pass.Writes[Write]) + "\n";
			if (!Parted.bOtherPasses && Parted.Pass == Index && Parted.Write == Write)
			{
				Text += "   < here they part; against it " + FormatWrite(Against[Index].Writes[Write]) + "\n";
			}
		}
		if (Parted.bOtherPasses && Parted.Pass == Index)
		{
			Text += Index < Against.size()
						? "   < here they part: the other run has the pass " + Against[Index].Pass + "\n"
						: std::string("   < here they part: the other run has no more passes\n");
		}
	}
	if (bCompare && !Difference)
	{
		Text += "\nThe same in both, in every pass.\n";
	}
	return Text;
}

std::string MakeProbeJson(
	const std::vector<FProbePass>& Passes, const std::vector<FProbePass>& Against, const FProbeRequest& Request)
{
	FJsonWriter Writer('{');
	Writer.Members({{"x", Request.X}, {"y", Request.Y}, {"width", Request.Width}, {"height", Request.Height}});
	for (const auto& [Key, List] : {std::pair("passes", &Passes), std::pair("against", &Against)})
	{
		Writer.Array(Key, *List, [&](const FProbePass& Pass) { WritePass(Writer, Pass); });
	}
	const std::optional<FProbeDifference> Difference =
		Against.empty() ? std::optional<FProbeDifference>() : FindDifference(Passes, Against);
	if (Difference)
	{
		Writer.Key("firstDifference")
			.Object({{"pass", uint64_t(Difference->Pass)}, {"write", uint64_t(Difference->Write)},
				{"otherPasses", Difference->bOtherPasses}});
	}
	return Writer.GetText();
}

} // namespace Drydock
