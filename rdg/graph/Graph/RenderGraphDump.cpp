// Writes a compiled graph as text, and as a picture for dot.
#include "RenderGraphDump.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <unordered_map>

namespace Drydock
{

namespace
{

/** printf into a string. */
std::string Format(const char* Text, ...) __attribute__((format(printf, 1, 2)));

std::string Format(const char* Text, ...)
{
	va_list Arguments;
	va_start(Arguments, Text);
	va_list Copy;
	va_copy(Copy, Arguments);
	const int Length = std::vsnprintf(nullptr, 0, Text, Copy);
	va_end(Copy);
	std::string Result(size_t(Length) + 1, '\0');
	std::vsnprintf(Result.data(), Result.size(), Text, Arguments);
	va_end(Arguments);
	Result.pop_back();
	return Result;
}

std::string DescribeBox(const FRDGResourceDescription& Resource, const FRDGSubresources& Box)
{
	std::string Text;
	if (Box.FirstMip != 0 || Box.NumMips != Resource.NumMips)
	{
		Text += Box.NumMips == 1 ? Format(" mip %d", Box.FirstMip)
								 : Format(" mips %d-%d", Box.FirstMip, Box.FirstMip + Box.NumMips - 1);
	}
	if (Box.Slice != 0 || Box.NumSlices != Resource.NumSlices)
	{
		Text += Box.NumSlices == 1 ? Format(" slice %d", Box.Slice)
								   : Format(" slices %d-%d", Box.Slice, Box.Slice + Box.NumSlices - 1);
	}
	if (Resource.NumPlanes > 1 && Box.NumPlanes == 1)
	{
		Text += Box.Plane == 0 ? " depth" : " stencil";
	}
	return Text;
}

/** By resource: its name; the second of one name and later ones get a number: "Blur #2". */
std::vector<std::string> MakeUniqueNames(const FRDGCompiledGraph& Graph)
{
	std::unordered_map<std::string, int> Numbers;
	std::vector<std::string> Names;
	for (const FRDGCompiledResource& Resource : Graph.Resources)
	{
		const int Number = ++Numbers[Resource.Name];
		Names.push_back(Number == 1 ? Resource.Name : Format("%s #%d", Resource.Name.c_str(), Number));
	}
	return Names;
}

/** "A, B mip 1", each once. */
std::string ListUses(const FRDGCompiledGraph& Graph, const std::vector<std::string>& ResourceNames,
	const FRDGCompiledPass& Pass, bool bWrites)
{
	std::vector<std::string> Names;
	for (const FRDGUse& Use : Pass.Uses)
	{
		const FRDGCompiledResource& Resource = Graph.Resources[size_t(Use.Resource)];
		const std::string Name = ResourceNames[size_t(Use.Resource)] + DescribeBox(Resource, Use);
		if ((bWrites ? Use.IsWrite() : Use.IsRead()) && std::find(Names.begin(), Names.end(), Name) == Names.end())
		{
			Names.push_back(Name);
		}
	}
	return JoinText(Names);
}

size_t FindNameWidth(const std::vector<std::string>& Names)
{
	size_t Width = 8;
	for (const std::string& Name : Names)
	{
		Width = std::max(Width, Name.size());
	}
	return Width;
}

std::string DumpPass(const FRDGCompiledGraph& Graph, const std::vector<std::string>& ResourceNames,
	const FRDGCompiledPass& Pass, const std::map<int, std::string>& ValuesByPass)
{
	std::string Text = Format("%4d  %s\n", Pass.Index, Pass.Name.c_str());
	const auto AddLine = [&Text](const char* Label, const std::string& Value)
	{
		Text += Value.empty() ? "" : Format("        %-8s %s\n", Label, Value.c_str());
	};
	AddLine("shader", Pass.Shader + (Pass.Entry.empty() ? "" : " (" + Pass.Entry + ")") +
						  (Pass.RunsAs.empty() ? "" : ", runs as " + Pass.RunsAs));
	AddLine("reads", ListUses(Graph, ResourceNames, Pass, false));
	AddLine("writes", ListUses(Graph, ResourceNames, Pass, true));
	const auto Values = ValuesByPass.find(Pass.Index);
	AddLine("values", Values == ValuesByPass.end() ? "" : Values->second);
	AddLine("begins", Pass.MergeReason.empty() ? "" : "a render pass: " + Pass.MergeReason);
	if (Pass.RenderPassBegin >= 0 && Pass.RenderPassBegin != Pass.Index)
	{
		AddLine("merged", "into the render pass of " + Graph.Passes[size_t(Pass.RenderPassBegin)].Name);
	}
	if (Pass.ForkPass >= 0)
	{
		AddLine("async", Format("from after pass %d to before pass %d", Pass.ForkPass, Pass.JoinPass));
	}
	return Text;
}

std::string DumpPasses(const FRDGCompiledGraph& Graph, const std::vector<std::string>& ResourceNames,
	const std::map<int, std::string>& ValuesByPass)
{
	std::string Text;
	std::string Scope;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		if (Pass.bIsSentinel || Pass.bCulled)
		{
			continue;
		}
		if (Pass.Scope != Scope)
		{
			Text += Pass.Scope.empty() ? "  -\n" : "  " + Pass.Scope + "\n";
			Scope = Pass.Scope;
		}
		Text += DumpPass(Graph, ResourceNames, Pass, ValuesByPass);
	}
	return Text;
}

std::string DescribeHome(const FRDGCompiledResource& Resource)
{
	return Resource.bExternal    ? (Resource.bExtracted ? "external, extracted" : "external")
		   : Resource.bTransient ? Format("heap at %lld", static_cast<long long>(Resource.HeapOffset))
		   : Resource.bExtracted ? "extracted"
								 : "pooled";
}

std::string Escape(const std::string& Text)
{
	std::string Result;
	for (const char Character : Text)
	{
		if (Character == '"' || Character == '\\')
		{
			Result += '\\';
		}
		Result += Character;
	}
	return Result;
}

} // namespace

std::string DescribeBytes(uint64_t Bytes)
{
	return Bytes >= 1024 * 1024 ? Format("%.2f MiB", double(Bytes) / (1024.0 * 1024.0))
		   : Bytes >= 1024      ? Format("%.1f KiB", double(Bytes) / 1024.0)
								: Format("%llu B", static_cast<unsigned long long>(Bytes));
}

std::string DescribeResource(const FRDGResourceDescription& Resource)
{
	if (Resource.Kind == ERDGResourceKind::Buffer)
	{
		return Format("buffer %d x %d B", Resource.Extent.X, Resource.Extent.Y);
	}
	std::string Text = Format("%s %dx%d", GPixelFormats[Resource.Format].Name, Resource.Extent.X, Resource.Extent.Y);
	Text += Resource.Extent.Z > 1 ? Format("x%d", Resource.Extent.Z) : "";
	Text += Resource.NumSlices > 1 ? Format(" [%d]", Resource.NumSlices) : "";
	Text += Resource.NumMips > 1 ? Format(" %d mips", Resource.NumMips) : "";
	return Text;
}

std::string DescribePassFlags(ERDGPassFlags Flags)
{
	static const std::pair<ERDGPassFlags, const char*> Names[] = {{ERDGPassFlags::Raster, "Raster"},
		{ERDGPassFlags::Compute, "Compute"}, {ERDGPassFlags::AsyncCompute, "AsyncCompute"},
		{ERDGPassFlags::Copy, "Copy"}, {ERDGPassFlags::NeverCull, "NeverCull"},
		{ERDGPassFlags::SkipRenderPass, "SkipRenderPass"}, {ERDGPassFlags::NeverMerge, "NeverMerge"},
		{ERDGPassFlags::NeverParallel, "NeverParallel"}, {ERDGPassFlags::ParallelTranslate, "ParallelTranslate"}};
	std::string Text;
	for (const auto& [Flag, Name] : Names)
	{
		if (EnumHasAnyFlags(Flags, Flag))
		{
			Text += (Text.empty() ? "" : "|") + std::string(Name);
		}
	}
	return Text.empty() ? "None" : Text;
}

std::string DumpText(const FRDGCompiledGraph& Graph, const std::map<int, std::string>& ValuesByPass)
{
	const auto IsCounted = [](const FRDGCompiledPass& Pass)
	{
		return !Pass.bIsSentinel;
	};
	const auto IsCulled = [](const FRDGCompiledPass& Pass)
	{
		return Pass.bCulled;
	};
	const long NumPasses = long(std::count_if(Graph.Passes.begin(), Graph.Passes.end(), IsCounted));
	const long NumCulled = long(std::count_if(Graph.Passes.begin(), Graph.Passes.end(), IsCulled));

	std::string Text = Format("graph %s: %ld passes run, %ld culled\n", Graph.Name.empty() ? "-" : Graph.Name.c_str(),
		NumPasses - NumCulled, NumCulled);
	const std::vector<std::string> ResourceNames = MakeUniqueNames(Graph);
	Text += "\npasses\n" + DumpPasses(Graph, ResourceNames, ValuesByPass);

	const int Width = int(FindNameWidth(ResourceNames));
	Text += "\nresources                     (first and last pass that hold it)\n";
	for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
	{
		const FRDGCompiledResource& Resource = Graph.Resources[Index];
		if (Resource.FirstPass >= 0)
		{
			Text += Format("  %-*s  %-34s %10s  %3d..%-3d  %s\n", Width, ResourceNames[Index].c_str(),
				DescribeResource(Resource).c_str(), DescribeBytes(Resource.Bytes).c_str(), Resource.FirstPass,
				Resource.LastPass, DescribeHome(Resource).c_str());
		}
	}

	std::string Culled;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		Culled += Pass.bCulled ? Format("%4d  %s\n        %s\n", Pass.Index, Pass.Name.c_str(),
									 Graph.DescribeCulled(Pass).c_str())
							   : "";
	}
	for (const FRDGCompiledResource& Resource : Graph.Resources)
	{
		Culled += Resource.FirstPass < 0
					  ? Format("   -  %s (%s)\n        %s\n", Resource.Name.c_str(), DescribeResource(Resource).c_str(),
							Graph.DescribeUnused(Resource).c_str())
					  : "";
	}
	Text += Culled.empty() ? "" : "\nleft out\n" + Culled;

	Text += Format("\nmemory\n  transient  %s with aliasing, %s without\n  pooled     %s\n  external   %s\n",
		DescribeBytes(Graph.Memory.TransientPeakBytes).c_str(),
		DescribeBytes(Graph.Memory.WithoutAliasingBytes).c_str(), DescribeBytes(Graph.Memory.PooledBytes).c_str(),
		DescribeBytes(Graph.Memory.ExternalBytes).c_str());
	return Text;
}

std::string DumpDot(const FRDGCompiledGraph& Graph)
{
	std::string Text =
		"digraph \"" + Escape(Graph.Name) + "\" {\n\trankdir=LR;\n\tnode [fontname=\"sans-serif\", fontsize=10];\n";
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		if (!Pass.bIsSentinel)
		{
			const std::string Shader = Pass.Shader.empty() ? "" : "\\n" + Escape(Pass.Shader);
			Text += Format("\tp%d [shape=box, style=%s, label=\"%d %s%s\"];\n", Pass.Index,
				Pass.bCulled ? "\"dashed\", color=grey, fontcolor=grey" : "filled, fillcolor=lightblue", Pass.Index,
				Escape(Pass.Name).c_str(), Shader.c_str());
		}
	}
	for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
	{
		const FRDGCompiledResource& Resource = Graph.Resources[Index];
		const char* const Style = Resource.FirstPass < 0 ? "style=dashed, color=grey, fontcolor=grey"
								  : Resource.bExternal   ? "style=filled, fillcolor=lightyellow"
								  : Resource.bExtracted  ? "style=filled, fillcolor=lightgreen"
														 : "style=solid";
		Text += Format("\tr%zu [shape=ellipse, %s, label=\"%s\\n%s\"];\n", Index, Style, Escape(Resource.Name).c_str(),
			DescribeResource(Resource).c_str());
	}
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		std::vector<std::string> Edges;
		const auto AddEdge = [&](const std::string& Edge)
		{
			if (std::find(Edges.begin(), Edges.end(), Edge) == Edges.end())
			{
				Edges.push_back(Edge);
				Text += Edge;
			}
		};
		const char* const Style = Pass.bCulled ? " [color=grey, style=dashed]" : "";
		for (const FRDGUse& Use : Pass.Uses)
		{
			if (Use.IsRead())
			{
				AddEdge(Format("\tr%d -> p%d%s;\n", Use.Resource, Pass.Index, Style));
			}
			if (Use.IsWrite())
			{
				AddEdge(Format("\tp%d -> r%d%s;\n", Pass.Index, Use.Resource, Style));
			}
		}
	}
	return Text + "}\n";
}

std::string DumpTransitions(const FRDGCompiledGraph& Graph)
{
	std::string Text;
	for (const FRDGTransition& Transition : Graph.Transitions)
	{
		const FRDGCompiledResource& Resource = Graph.Resources[size_t(Transition.Resource)];
		Text += Format("%d -> %d  %s%s: %s -> %s%s\n", Transition.BeginPass, Transition.EndPass, Resource.Name.c_str(),
			DescribeBox(Resource, Transition).c_str(), *GetRHIAccessName(Transition.Before),
			*GetRHIAccessName(Transition.After), Transition.bUAVBarrier ? " (UAV barrier)" : "");
	}
	return Text;
}

} // namespace Drydock
