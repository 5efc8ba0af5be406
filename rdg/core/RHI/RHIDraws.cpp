// Finds what draws cover: the viewport, or the rectangles that a vertex shader makes. Source: engine RHICommandList.h
// for meaning; the execution is drydock's.
#include "CommonRenderResources.h"
#include "VertexRectangles.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{

/** Each vertex is interpreted; post-processing does not draw more. */
constexpr uint64 GMaxTriangles = 8192;

/** Runs the engine's vertex shader of screen passes on the unit square's corners, as ScreenPass.usf has it. Parameters:
 * contents of the uniform buffer DrawRectangleParameters. */
std::vector<Drydock::FVertexOutput> RunScreenPassVS(const void* Parameters, uint32 NumBytes)
{
	struct
	{
		float PosScaleBias[4];
		float UVScaleBias[4];
		float InvTargetSizeAndTextureSize[4];
	} Given = {};
	std::memcpy(&Given, Parameters, std::min<size_t>(sizeof(Given), NumBytes));
	constexpr float Corners[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}};
	std::vector<Drydock::FVertexOutput> Vertices;
	for (const float(&Corner)[2] : Corners)
	{
		Drydock::FVertexOutput& Vertex = Vertices.emplace_back();
		for (int32 Axis = 0; Axis < 2; ++Axis)
		{
			const float Pixel = Corner[Axis] * Given.PosScaleBias[Axis] + Given.PosScaleBias[2 + Axis];
			const float ViewportUV = Pixel * Given.InvTargetSizeAndTextureSize[Axis];
			const float Texel = Corner[Axis] * Given.UVScaleBias[Axis] + Given.UVScaleBias[2 + Axis];
			Vertex.Position[Axis] = Axis == 0 ? 2.0f * ViewportUV - 1.0f : 1.0f - 2.0f * ViewportUV;
			Vertex.TexCoords[0][Axis] = Texel * Given.InvTargetSizeAndTextureSize[2 + Axis];
			Vertex.TexCoords[0][2 + Axis] = Vertex.Position[Axis];
		}
		Vertex.Position[3] = 1.0f;
	}
	return Vertices;
}

Drydock::FDiagnostic MakeNoRectangle(const std::string& VertexShader, const std::string& Fault)
{
	return Drydock::MakeVertexDiagnostic(Drydock::ESeverity::Warning, Drydock::WarnNoRectangle,
		"nothing is drawn with vertex shader " + VertexShader + ": " + Fault +
			". drydock draws triangles of the screen, whose w is the same at all vertices");
}

} // namespace

FIntRect FRHICommandList::GetDrawRect() const
{
	FIntRect Rect = Viewport;
	const auto Clip = [&Rect](const FIntRect& To)
	{
		Rect.Min = FIntPoint(std::max(Rect.Min.X, To.Min.X), std::max(Rect.Min.Y, To.Min.Y));
		Rect.Max = FIntPoint(std::min(Rect.Max.X, To.Max.X), std::min(Rect.Max.Y, To.Max.Y));
	};
	for (const FRHIRenderPassInfo::FColorEntry& Entry : RenderPass.ColorRenderTargets)
	{
		if (Entry.RenderTarget)
		{
			const Drydock::FTextureMipLayout& At = Entry.RenderTarget->GetMipLayout(Entry.MipIndex);
			Clip(FIntRect(0, 0, At.SizeX, At.SizeY));
		}
	}
	if (FRHITexture* const Depth = RenderPass.DepthStencilRenderTarget.DepthStencilTarget)
	{
		Clip(FIntRect(FIntPoint(0, 0), Depth->GetSizeXY()));
	}
	if (bScissor)
	{
		Clip(Scissor);
	}
	return Rect;
}

std::vector<Drydock::FKernelInterpolant> FRHICommandList::MakeInterpolants(int32 NumRead) const
{
	std::vector<Drydock::FKernelInterpolant> Result = Interpolants;
	if (Result.empty())
	{
		const double Width = Viewport.Width();
		const double Height = Viewport.Height();
		const double U = -Viewport.Min.X / Width;
		const double V = -Viewport.Min.Y / Height;
		Result.push_back({
			{U, V, 2 * U - 1, 1 - 2 * V},
			{1 / Width, 0, 2 / Width, 0},
			{0, 1 / Height, 0, -2 / Height},
		});
	}
	Result.resize(std::max(Result.size(), size_t(NumRead)));
	return Result;
}

void FRHICommandList::CheckDraw()
{
	checkf(bInsideRenderPass, TEXT("a draw outside a render pass"));
	Drydock::BindIfNothingIs(BoundPixel, PixelShader);
	checkf(BoundPixel.IsValid(), TEXT("a draw without a pixel shader: call SetShaderParameters first"));
	checkf(BoundPixel.GetReflection().Stage == Drydock::EShaderStage::Pixel, TEXT("a draw: %s is not a pixel shader"),
		BoundPixel.Name.c_str());
	// A depth that the shader computes is written; the rectangle's own is not known.
	const bool bWrites = BoundPixel.GetReflection().bWritesDepth;
	checkf(!RenderPass.DepthStencilRenderTarget.DepthStencilTarget || !DepthStencilState ||
			   !DepthStencilState->IsTesting(bWrites),
		TEXT("%s: depth and stencil tests are not simulated, nor writes but those of SV_Depth; use "
			 "TStaticDepthStencilState<%s, CF_Always>"),
		BoundPixel.Name.c_str(), bWrites ? TEXT("true") : TEXT("false"));
}

std::vector<Drydock::FKernelTarget> FRHICommandList::MakeTargets() const
{
	const Drydock::FShaderReflection& Reflection = BoundPixel.GetReflection();
	const int32 NumWritten = Reflection.NumTargets;
	// Outputs without a target are dropped: a write mask of 0, and a texture without texels behind it.
	static const Drydock::FKernelMip NoTexels{};
	Drydock::FKernelTarget NoTarget{};
	NoTarget.Texture = {&NoTexels, 1, Drydock::ETexelStorage::R32_FLOAT, 0, 0};
	const int32 NumBound = RenderPass.GetNumColorRenderTargets();
	std::vector<Drydock::FKernelTarget> Targets(size_t(std::max(NumBound, NumWritten)), NoTarget);
	for (int32 Index = 0; Index < NumBound; ++Index)
	{
		const FRHIRenderPassInfo::FColorEntry& Entry = RenderPass.ColorRenderTargets[Index];
		if (!Entry.RenderTarget || Index >= NumWritten)
		{
			continue;
		}
		const bool bIntegers = Reflection.IntegerTargets >> Index & 1;
		const EPixelFormat Format = Entry.RenderTarget->GetFormat();
		if (bIntegers != IsInteger(Format))
		{
			throw Drydock::FError(
				Drydock::MakeVertexDiagnostic(Drydock::ESeverity::Error, Drydock::ErrorTargetKind,
					"pixel shader " + BoundPixel.Name + " writes " + (bIntegers ? "integers" : "floats") +
						" to SV_Target" + std::to_string(Index) + ", which is " +
						Entry.RenderTarget->GetName().ToString().ToStdString() + " of " + GetPixelFormatString(Format) +
						(bIntegers ? "; give it a format of integers, or return float4" : "; return uint4")),
				Drydock::ExitUsage);
		}
		Drydock::FKernelTarget& Target = Targets[Index];
		Target.Texture = Entry.RenderTarget->GetKernelView(Entry.MipIndex, 1, std::max(0, Entry.ArraySlice));
		FBlendStateInitializerRHI::FRenderTarget Blend;
		if (BlendState)
		{
			Blend = BlendState->GetTarget(Index);
		}
		Target.WriteMask = uint8(Blend.ColorWriteMask);
		Target.bBlend = Blend.IsBlending() && !bIntegers; // Direct3D: integers do not blend
		Target.ColorOp = Drydock::EKernelBlendOp(Blend.ColorBlendOp);
		Target.ColorSource = Drydock::EKernelBlendFactor(Blend.ColorSrcBlend);
		Target.ColorDest = Drydock::EKernelBlendFactor(Blend.ColorDestBlend);
		Target.AlphaOp = Drydock::EKernelBlendOp(Blend.AlphaBlendOp);
		Target.AlphaSource = Drydock::EKernelBlendFactor(Blend.AlphaSrcBlend);
		Target.AlphaDest = Drydock::EKernelBlendFactor(Blend.AlphaDestBlend);
	}
	FRHITexture* const Depth = RenderPass.DepthStencilRenderTarget.DepthStencilTarget;
	const bool bDepth = Depth && DepthStencilState && DepthStencilState->GetInitializer().bEnableDepthWrite;
	if (bDepth && Reflection.bWritesDepth)
	{
		Targets.resize(Drydock::GDepthTarget + 1, NoTarget);
		Targets[Drydock::GDepthTarget].Texture = Depth->GetKernelView(0, 1, 0);
		Targets[Drydock::GDepthTarget].WriteMask = 1;
	}
	return Targets;
}

/** By their indices in the kernel's targets. */
std::vector<FRHITexture*> FRHICommandList::GetTargetTextures() const
{
	std::vector<FRHITexture*> Textures;
	for (const FRHIRenderPassInfo::FColorEntry& Entry : RenderPass.ColorRenderTargets)
	{
		Textures.push_back(Entry.RenderTarget);
	}
	Textures.resize(Drydock::GDepthTarget);
	Textures.push_back(RenderPass.DepthStencilRenderTarget.DepthStencilTarget);
	return Textures;
}

void FRHICommandList::DrawViewport(uint32 NumInstances)
{
	CheckDraw();
	Vertices.CheckTexCoords(BoundPixel);
	DrawRect(GetDrawRect(), MakeInterpolants(BoundPixel.GetReflection().NumInterpolants), NumInstances);
}

void FRHICommandList::SetStreamSource(uint32 StreamIndex, FRHIBuffer* Buffer, uint32 Offset)
{
	checkf(StreamIndex < uint32(Drydock::FVertexState::MaxStreams), TEXT("SetStreamSource: stream %u; there are %d"),
		StreamIndex, Drydock::FVertexState::MaxStreams);
	Vertices.Streams[StreamIndex] = {Buffer, Offset};
}

void FRHICommandList::DrawPrimitive(uint32 BaseVertexIndex, uint32 NumPrimitives, uint32 NumInstances)
{
	Drydock::FVertexDraw Draw;
	Draw.BaseVertex = int32(BaseVertexIndex);
	Draw.NumPrimitives = NumPrimitives;
	DrawVertices(Draw, NumInstances);
}

void FRHICommandList::DrawIndexedPrimitive(FRHIBuffer* IndexBuffer, int32 BaseVertexIndex, uint32 FirstInstance, uint32,
	uint32 StartIndex, uint32 NumPrimitives, uint32 NumInstances)
{
	DrawVertices({IndexBuffer, true, BaseVertexIndex, StartIndex, FirstInstance, NumPrimitives}, NumInstances);
}

void FRHICommandList::DrawScreenRectangle(const void* Parameters, uint32 NumBytes)
{
	if (!HasVertexShader())
	{
		CheckDraw();
		Vertices.CheckTexCoords(BoundPixel);
		Drydock::FDrawnRectangles Drawn =
			Drydock::FindDrawnRectangles(RunScreenPassVS(Parameters, NumBytes), Viewport, GetDrawRect(), 1);
		if (!Drawn.Fault.empty())
		{
			Counters.AddRemark(MakeNoRectangle("FScreenPassVS", Drawn.Fault));
		}
		for (Drydock::FDrawnRectangle& Rectangle : Drawn.Rectangles)
		{
			const int32 NumRead = BoundPixel.GetReflection().NumInterpolants;
			Rectangle.Interpolants.resize(size_t(std::max(NumRead, 1)));
			DrawRect(Rectangle.Rect, Rectangle.Interpolants, 1);
		}
		return;
	}
	Drydock::BindIfNothingIs(Vertices.Bound, Vertices.Shader);
	Drydock::RequireAllSet(Vertices.Bound);
	const std::vector<Drydock::FShaderConstantBuffer>& Buffers = Vertices.Bound.GetReflection().ConstantBuffers;
	for (size_t Buffer = 0; Buffer < Buffers.size(); ++Buffer)
	{
		if (Buffers[Buffer].Name == Drydock::GDrawRectangleParametersName)
		{
			std::vector<uint8_t>& Data = Vertices.Bound.ConstantData[Buffer];
			std::memcpy(Data.data(), Parameters, std::min<size_t>(Data.size(), NumBytes));
		}
	}
	Vertices.bDrawsScreenRectangle = true;
	SetStreamSource(0, GScreenRectangleVertexBuffer.VertexBufferRHI, 0);
	DrawIndexedPrimitive(GScreenRectangleIndexBuffer.IndexBufferRHI, 0, 0, 4, 0, 2, 1);
	Vertices.bDrawsScreenRectangle = false;
}

void FRHICommandList::DrawVertices(const Drydock::FVertexDraw& Draw, uint32 NumInstances)
{
	if (!HasVertexShader())
	{
		DrawViewport(Draw.NumPrimitives > 0 ? std::max(1u, NumInstances) : 0);
		return;
	}
	CheckDraw();
	Drydock::BindIfNothingIs(Vertices.Bound, Vertices.Shader);
	Drydock::RequireAllSet(Vertices.Bound);
	Vertices.CheckInput(Draw);
	const Drydock::FShaderReflection& Read = BoundPixel.GetReflection();
	Vertices.CheckTexCoords(BoundPixel);

	const uint64 NumTriangles = uint64(Draw.NumPrimitives) * std::max(1u, NumInstances);
	Drydock::FDrawnRectangles Drawn;
	if (Vertices.PrimitiveType != PT_TriangleList && Vertices.PrimitiveType != PT_TriangleStrip)
	{
		Drawn.Fault = "it draws lists of rectangles or quads, which graphics cards of today do not know";
	}
	else if (NumTriangles > GMaxTriangles)
	{
		Drawn.Fault = "it draws " + std::to_string(NumTriangles) + " triangles, and " + std::to_string(GMaxTriangles) +
					  " are the most";
	}
	const FIntRect Bounds = GetDrawRect();
	Counters.Ran |= Drydock::EShaderRun::Interpreter;
	for (uint32 Instance = 0; Instance < std::max(1u, NumInstances) && Drawn.Fault.empty(); ++Instance)
	{
		Drydock::FDrawnRectangles OfInstance = Drydock::FindDrawnRectangles(Vertices.RunVertices(Draw, Instance, Read),
			Viewport, Bounds, Read.NumInterpolants, Read.IntegerInterpolants, Read.NamedInterpolants);
		Drawn.Fault = OfInstance.Fault;
		std::move(OfInstance.Rectangles.begin(), OfInstance.Rectangles.end(), std::back_inserter(Drawn.Rectangles));
	}
	if (!Drawn.Fault.empty())
	{
		Counters.AddRemark(MakeNoRectangle(Vertices.Bound.Name, Drawn.Fault));
		return;
	}
	for (const Drydock::FDrawnRectangle& Rectangle : Drawn.Rectangles)
	{
		DrawRect(Rectangle.Rect, Rectangle.Interpolants, 1);
	}
}
