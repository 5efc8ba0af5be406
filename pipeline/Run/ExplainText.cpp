// The text that `drydock explain` prints.
#include "Run/Explain.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

std::string Count(int Number, const char* Thing)
{
	return std::to_string(Number) + " " + Thing +
		   (Number == 1                                      ? ""
			   : Thing[std::string(Thing).size() - 1] == 's' ? "es"
															 : "s");
}

std::string FormatMilliseconds(const FExplainReport& Report, double Milliseconds)
{
	return fmt::format("{}{:.1f} ms", Report.bMeasured ? "" : "about ", Milliseconds);
}

/** The row of an effect or a plugin. */
template<typename TRow>
std::vector<std::string> MakeRow(const std::string& Name, bool bRuns, const TRow& Row, const std::string& Why)
{
	const bool bAny = Row.NumPasses > 0;
	return {Name, bRuns ? "yes" : "no", bAny ? std::to_string(Row.NumPasses) : "-",
		bAny ? fmt::format("{:.2f}", Row.Milliseconds) : "-", bAny ? fmt::format("{:.1f}", Row.Megabytes) : "-", Why};
}

/** The effects with their reasons; effects that do not run are dim. */
FTextTable MakeEffectTable(const FExplainReport& Report, bool bColorful)
{
	constexpr ETextColumn Number = ETextColumn::Number;
	FTextTable Table{
		{{ETextColumn::Name}, {ETextColumn::Text}, {Number}, {Number}, {Number}, {ETextColumn::Text}}, {}, {}};
	const auto Add = [&](const std::vector<std::string>& Row, const char* Color)
	{
		Table.Rows.push_back(Row);
		Table.Colors.emplace_back(bColorful ? Color : "");
	};
	Add({"effect", "runs", "passes", Report.bMeasured ? "ms" : "est. ms", "MB", "why"}, "\x1b[1m");
	for (const FExplainedEffect& Effect : Report.Effects)
	{
		const FEffectDecision& Decision = Effect.Decision;
		Add(MakeRow(Decision.GetName(), Decision.bActive, Effect, Decision.Reason), Decision.bActive ? "" : "\x1b[2m");
	}
	for (const FExplainedPlugin& Plugin : Report.Plugins)
	{
		Add(MakeRow(Plugin.Name, Plugin.NumPasses > 0, Plugin, "its code added them"), "");
	}
	return Table;
}

/** "1.2 million texels"; "no texel (0.1 million more)": a region costs a copy, which now and then is more. */
std::string FormatCounted(uint64_t Without, uint64_t With, double Unit, const char* What)
{
	const double Saved = (static_cast<double>(Without) - static_cast<double>(With)) / Unit;
	return Saved < 0.0 ? fmt::format("{:.1f} {} more", -Saved, What) : fmt::format("{:.1f} {}", Saved, What);
}

std::string FormatSavedTime(const FExplainReport& Report)
{
	if (!Report.Saved)
	{
		return fmt::format(
			"about {:.1f} ms on this machine", Report.WithoutSkipping.Milliseconds - Report.Cost.Milliseconds);
	}
	return fmt::format("{:.1f} ms ({:.1f} to {:.1f} in {} pairs of runs)", Report.Saved->Median, Report.Saved->Least,
		Report.Saved->Most, Report.Saved->NumPairs);
}

/** Counts come first, because they are the same in every run. */
std::string FormatSaved(const FExplainReport& Report)
{
	const FExplainedCost& With = Report.Cost;
	const FExplainedCost& Without = Report.WithoutSkipping;
	// A region costs a copy, and now and then that is one pass more.
	const int NumPasses = Without.NumPasses - With.NumPasses;
	std::string Text = NumPasses < 0 ? fmt::format("no pass ({} more)", -NumPasses) : Count(NumPasses, "pass");
	Text += ", " + FormatCounted(Without.Texels, With.Texels, 1e6, "million texels");
	if (Report.bMeasured)
	{
		const bool bTaps = Without.Taps && With.Taps;
		Text += (bTaps ? ", " + FormatCounted(*Without.Taps, *With.Taps, 1e6, "million taps") : std::string()) + ", " +
				FormatCounted(Without.BytesMoved, With.BytesMoved, 1e6, "MB read and written");
	}
	Text += ", " +
			FormatCounted(Without.TransientBytes + Without.SceneBytes, With.TransientBytes + With.SceneBytes, 1e6,
				"MB of memory") +
			", " + Count(Without.NumChannels - With.NumChannels, "channel");
	return fmt::format("saved    {}; {}, against the same frame with --no-skip\n", Text, FormatSavedTime(Report));
}

std::string List(const std::vector<std::string>& Names, const char* Otherwise)
{
	const std::string Text = JoinText(Names);
	return Text.empty() ? Otherwise : Text;
}

std::vector<std::string> MakePassRow(const FExplainedPass& Pass)
{
	return {std::to_string(Pass.Index), Pass.Name,
		Pass.bExecutes ? fmt::format("{:.2f} ms", Pass.Milliseconds) : "culled",
		Pass.bExecutes ? "read by " + List(Pass.Readers, "no pass of the graph: it is an output") : Pass.Reason};
}

[[noreturn]] void ThrowUnknown(const char* Thing, const std::string& Name, const std::vector<std::string>& Names)
{
	const std::string Hint = SuggestName(Name, Names);
	throw BadArgument(fmt::format("this frame has no {} {}{}", Thing, Name, Hint), std::string("--") + Thing);
}

/** By its whole name, its index, or the name without what follows it ("BloomSetup" for "BloomSetup 480x270 (PS)"). */
bool IsCalled(const FExplainedPass& Pass, const std::string& Name)
{
	const bool bBegins = Pass.Name.starts_with(Name) && Pass.Name.size() > Name.size() &&
						 (Pass.Name[Name.size()] == ' ' || Pass.Name[Name.size()] == '(');
	return Pass.Name == Name || std::to_string(Pass.Index) == Name || bBegins;
}

void WriteCost(FJsonWriter& Writer, const char* Key, const FExplainedCost& Cost)
{
	Writer.Key(Key).Object({{"passes", Cost.NumPasses}, {"channels", Cost.NumChannels}, {"texels", Cost.Texels},
		{"taps", Cost.Taps}, {"bytesMoved", Cost.BytesMoved}, {"transientPeakBytes", Cost.TransientBytes},
		{"sceneTextureBytes", Cost.SceneBytes}, {"ms", Cost.Milliseconds}});
}

} // namespace

std::string MakeExplainText(const FExplainReport& Report, bool bColorful, int Width)
{
	std::string Text = MakeEffectTable(Report, bColorful).Format(Width);
	std::string Extensions;
	int NumCulled = 0;
	for (const FExplainedPass& Pass : Report.Passes)
	{
		NumCulled += !Pass.bExecutes;
		if (Pass.Effect.empty() && Pass.bExecutes)
		{
			Extensions += (Extensions.empty() ? "" : ", ") + Pass.Name;
		}
	}
	std::string Decoded;
	for (const FSceneChannel& Channel : Report.Channels)
	{
		Decoded += Channel.bDecoded ? (Decoded.empty() ? "" : ", ") + Channel.Name : "";
	}
	Text += fmt::format("\npasses   {} run, {} culled{}; {}\n", Report.Cost.NumPasses, NumCulled,
		NumCulled > 0 ? " (explain --pass NAME shows why)" : "", FormatMilliseconds(Report, Report.Cost.Milliseconds));
	if (!Extensions.empty())
	{
		Text += "others   passes that belong to no effect (view extensions, copies): " + Extensions + "\n";
	}
	Text += fmt::format("memory   {:.1f} MB transient, {:.1f} MB scene textures\n",
		1e-6 * static_cast<double>(Report.Cost.TransientBytes), 1e-6 * static_cast<double>(Report.Cost.SceneBytes));
	Text += fmt::format("scene    {} of {} decoded: {}\n", Report.Cost.NumChannels,
		Count(static_cast<int>(Report.Channels.size()), "channel"), Decoded.empty() ? "none" : Decoded);
	Text += FormatSaved(Report);
	if (!Report.bMeasured && Report.NumUnknown > 0)
	{
		Text += Count(Report.NumUnknown, "pass") +
				" never ran on this machine under these conditions: their times are guesses. A run or " +
				"--measure replaces them with measured times.\n";
	}
	return Text;
}

std::string MakePassText(const FExplainReport& Report, const std::string& Name)
{
	std::string Text;
	std::vector<std::string> Names;
	for (const FExplainedPass& Pass : Report.Passes)
	{
		Names.push_back(Pass.Name.substr(0, Pass.Name.find_first_of(" (")));
		if (!IsCalled(Pass, Name))
		{
			continue;
		}
		Text += "pass " + std::to_string(Pass.Index) + ", " + Pass.Name + "\n";
		Text += "  effect   " + (Pass.Effect.empty() ? "none: a view extension's pass, or a copy" : Pass.Effect) + "\n";
		Text += "  runs     " +
				(Pass.bExecutes ? "yes, " + FormatMilliseconds(Report, Pass.Milliseconds) : "no: " + Pass.Reason) +
				"\n";
		Text += "  shader   " + (Pass.Shader.empty() ? "chosen by the pass itself" : Pass.Shader) +
				(Pass.RunsAs.empty() ? "" : ", runs as " + Pass.RunsAs) + "\n";
		Text += Pass.Silent.empty() ? "" : "  note     " + Pass.Silent + "\n";
		Text += Pass.Values.empty() ? "" : "  values   " + FormatPassValues(Pass.Values) + "\n";
		Text += Pass.MergeReason.empty() ? "" : "  begins   a render pass: " + Pass.MergeReason + "\n";
		Text += Pass.MergedInto.empty() ? "" : "  merged   into the render pass of " + Pass.MergedInto + "\n";
		Text += "  reads    " + List(Pass.Reads, "nothing") + "\n";
		Text += "  writes   " + List(Pass.Writes, "nothing") + "\n";
		Text += "  read by  " + List(Pass.Readers, "no pass: it is an output, or unused") + "\n";
	}
	if (Text.empty())
	{
		ThrowUnknown("pass", Name, Names);
	}
	return Text;
}

std::string MakeEffectText(const FExplainReport& Report, const std::string& Name, int Width)
{
	std::string Text;
	std::vector<std::string> Names;
	for (const FExplainedEffect& Effect : Report.Effects)
	{
		Names.push_back(Effect.Decision.GetName());
		if (Effect.Decision.GetName() == Name)
		{
			Text = Name + (Effect.Decision.bActive ? " runs: " : " does not run: ") + Effect.Decision.Reason + "\n";
		}
	}
	for (const FExplainedPlugin& Plugin : Report.Plugins)
	{
		Names.push_back(Plugin.Name);
		Text = Plugin.Name == Name ? Name + " added:\n" : Text;
	}
	if (Text.empty())
	{
		ThrowUnknown("effect", Name, Names);
	}
	FTextTable Table{{{ETextColumn::Number}, {ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Text}}, {}};
	for (const FExplainedPass& Pass : Report.Passes)
	{
		if (Pass.Effect == Name)
		{
			Table.Rows.push_back(MakePassRow(Pass));
		}
	}
	return Text + Table.Format(Width, "  ");
}

std::string MakeExplainJson(const FExplainReport& Report)
{
	FJsonWriter Writer('{');
	Writer.Members({{"config", Report.Config}, {"measured", Report.bMeasured}});
	Writer.Array("effects", Report.Effects,
		[&](const FExplainedEffect& Effect)
		{
			Writer.Object({{"name", Effect.Decision.GetName()}, {"active", Effect.Decision.bActive},
				{"reason", Effect.Decision.Reason}, {"passes", Effect.NumPasses}, {"culled", Effect.NumCulled},
				{"ms", Effect.Milliseconds}, {"megabytes", Effect.Megabytes}});
		});
	Writer.Array("plugins", Report.Plugins,
		[&](const FExplainedPlugin& Plugin)
		{
			Writer.Object({{"name", Plugin.Name}, {"passes", Plugin.NumPasses}, {"culled", Plugin.NumCulled},
				{"ms", Plugin.Milliseconds}, {"megabytes", Plugin.Megabytes}});
		});
	Writer.Objects("passes", Report.Passes,
		[&](const FExplainedPass& Pass)
		{
			Writer.Members({{"index", Pass.Index}, {"name", Pass.Name}, {"effect", Pass.Effect},
				{"executes", Pass.bExecutes}, {"reason", Pass.Reason}, {"ms", Pass.Milliseconds},
				{"mergeReason", Pass.MergeReason}, {"mergedInto", Pass.MergedInto}, {"silent", Pass.Silent}});
			WriteValues(Writer, Pass.Values);
			Writer.Members({{"reads", Pass.Reads}, {"writes", Pass.Writes}, {"readers", Pass.Readers}});
		});
	WriteCost(Writer, "cost", Report.Cost);
	WriteCost(Writer, "withoutSkipping", Report.WithoutSkipping);
	if (Report.Saved)
	{
		Writer.Key("savedMs").Object({{"least", Report.Saved->Least}, {"median", Report.Saved->Median},
			{"most", Report.Saved->Most}, {"pairs", Report.Saved->NumPairs}});
	}
	return Writer.GetText();
}

} // namespace Drydock
