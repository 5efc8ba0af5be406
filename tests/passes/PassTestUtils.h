// Runs one pass on a synthetic texture, in three lines:
//
//     FPassRun Run(FImage::Noise(641, 359), EArithmetic::Native);
//     const FScreenPassTexture Output = AddDownsamplePass(Run.GraphBuilder, Run.View, {...Run.Input...});
//     const FImage Result = Run.Execute(Output);
//
// The input's texels outside the view rect are NaN, so that a pass that reads them shows it.
#pragma once

#include <gtest/gtest.h>

#include "PassReference.h"

#include "Exposure/PostProcessEyeAdaptation.h"
#include "HAL/ConsoleVariableTools.h"
#include "HAL/IConsoleManager.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace PassTest
{

using PassReference::FTexel;
using PassReference::operator+;
using PassReference::operator*;
using PassReference::FImage;
using PassReference::FRect;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Drydock::FScopedConsoleVariable;

enum class EArithmetic
{
	Native,  // float arithmetic, the format's own storage, coordinates snapped to 1/256 texel
	Float32, // float arithmetic and storage, snapped
	Double,  // double arithmetic and storage, snapped
	Exact,   // double arithmetic and storage, not snapped
};

inline bool IsDouble(EArithmetic Arithmetic)
{
	return Arithmetic >= EArithmetic::Double;
}

inline bool IsSnapped(EArithmetic Arithmetic)
{
	return Arithmetic != EArithmetic::Exact;
}

/** The values of a texture as stored, whole extent. */
inline FImage ReadTexture(FRHITexture* Texture)
{
	const FIntPoint Extent = Texture->GetSizeXY();
	return FImage::Make(Extent.X, Extent.Y,
		[&](int X, int Y)
		{
			const FVector4 Value = Texture->ReadTexelDouble(X, Y);
			return FTexel{Value.X, Value.Y, Value.Z, Value.W};
		});
}

class FPassRun
{
private:
	// Before the graph and its textures: storage is chosen when a texture is created.
	FScopedConsoleVariable Precision;
	FScopedConsoleVariable Storage;
	FScopedConsoleVariable SampleBits;

public:
	/** The image fills the texture. */
	FPassRun(const FImage& Image, EArithmetic Arithmetic, EPixelFormat Format = PF_FloatRGBA)
		: FPassRun(Image, {0, 0, Image.Width, Image.Height}, FIntPoint(Image.Width, Image.Height), Arithmetic, Format)
	{
	}

	/** The image fills Rect of a texture of Extent, whose other texels are NaN. */
	FPassRun(const FImage& Image, const FRect& Rect, FIntPoint Extent, EArithmetic Arithmetic,
		EPixelFormat Format = PF_FloatRGBA)
		: Precision(TEXT("r.Drydock.Precision"), IsDouble(Arithmetic) ? 1.0f : 0.0f)
		, Storage(TEXT("r.Drydock.Storage"), IsDouble(Arithmetic)                 ? 2.0f
											 : Arithmetic == EArithmetic::Float32 ? 1.0f
																				  : 0.0f)
		, SampleBits(TEXT("r.Drydock.SampleBits"), IsSnapped(Arithmetic) ? 8.0f : 0.0f)
		, GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("PassTest"))
		, View(nullptr, FIntRect(Rect.MinX, Rect.MinY, Rect.MaxX, Rect.MaxY), Extent)
	{
		Input = AddInput(Image, Rect, Extent, Format, TEXT("Input"));
	}

	FScreenPassTexture AddInput(
		const FImage& Image, const FRect& Rect, FIntPoint Extent, EPixelFormat Format, const TCHAR* Name)
	{
		const FRDGTextureDesc Desc =
			FRDGTextureDesc::Create2D(Extent, Format, FClearValueBinding::None, TexCreate_ShaderResource);
		const FTextureRHIRef Texture = new FRHITexture(Desc, Name);
		for (int Y = 0; Y < Extent.Y; ++Y)
		{
			for (int X = 0; X < Extent.X; ++X)
			{
				const bool bInside = X >= Rect.MinX && X < Rect.MaxX && Y >= Rect.MinY && Y < Rect.MaxY;
				const FTexel Color = bInside ? Image.At(X - Rect.MinX, Y - Rect.MinY) : FTexel{NaN, NaN, NaN, NaN};
				Texture->WriteTexelDouble(X, Y, FVector4(Color[0], Color[1], Color[2], Color[3]));
			}
		}
		return FScreenPassTexture(GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Name)),
			FIntRect(Rect.MinX, Rect.MinY, Rect.MaxX, Rect.MaxY));
	}

	FScreenPassTexture AddInput(const FImage& Image, EPixelFormat Format, const TCHAR* Name)
	{
		return AddInput(Image, {0, 0, Image.Width, Image.Height}, FIntPoint(Image.Width, Image.Height), Format, Name);
	}

	/** Runs the graph and gives what Output's rect holds. */
	FImage Execute(const FScreenPassTexture& Output)
	{
		TRefCountPtr<IPooledRenderTarget> Extracted;
		GraphBuilder.QueueTextureExtraction(Output.Texture, &Extracted);
		GraphBuilder.Execute();
		const FIntRect& Rect = Output.ViewRect;
		return PassReference::Crop(ReadTexture(Extracted->GetRHI()), {Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y});
	}

	FRDGBuilder GraphBuilder;
	FViewInfo View;
	FScreenPassTexture Input;
};

inline std::string ToString(EArithmetic Arithmetic)
{
	static const char* const Names[] = {"native", "float32", "double", "exact"};
	return Names[static_cast<int>(Arithmetic)];
}

/** So that a failed test names it. */
inline void PrintTo(EArithmetic Arithmetic, std::ostream* Stream)
{
	*Stream << ToString(Arithmetic);
}

/** Names parameterised tests. */
struct FArithmeticName
{
	template<typename TInfo>
	std::string operator()(const TInfo& Info) const
	{
		return ToString(Info.param);
	}
};

constexpr EArithmetic AllArithmetic[] = {
	EArithmetic::Native, EArithmetic::Float32, EArithmetic::Double, EArithmetic::Exact};

/** For passes that read each texel at its centre: without snapping, float texture coordinates miss it by a few 2^-24 of
 *  the size, which says nothing of the pass. */
constexpr EArithmetic SnappedArithmetic[] = {EArithmetic::Native, EArithmetic::Float32, EArithmetic::Double};

} // namespace PassTest
