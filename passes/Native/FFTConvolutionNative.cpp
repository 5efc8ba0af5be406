// The transforms themselves, line by line. Two neighbouring lines of a real picture are the real and the imaginary part
// of one complex line: their spectra come apart by symmetry. The method is the textbook's.
#include "Bloom/FFTConvolution.h"
#include "Native/FourierTransform.h"
#include "RenderGraphBuilder.h"
#include "ShaderParameterStruct.h"
#include "TileExecutor.h"

#include <vector>

namespace Drydock
{

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FFFTPassParameters, )
	RDG_TEXTURE_ACCESS(Input, ERHIAccess::SRVCompute)
	RDG_TEXTURE_ACCESS(Output, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

constexpr int32 NumChannels = 3;
/** Lines that a tile transforms: enough to use the cache lines that a column reads. */
constexpr int32 LinesPerTile = 8;

/** Texels of a rect as lines along either axis. */
template<typename ScalarType>
struct TLines
{
	ScalarType* First;
	ptrdiff_t StepAlong, StepAcross; // in scalars

	ScalarType* At(int32 Position, int32 Line) const { return First + Position * StepAlong + Line * StepAcross; }
};

template<typename ScalarType>
TLines<ScalarType> GetLines(FRHITexture& Texture, FIntPoint Origin, bool bAlongX)
{
	const FKernelMip& Mip = Texture.GetKernelView().Mips[0];
	Texture.Touch();
	const ptrdiff_t StepX = 4, StepY = Mip.RowPitch / ptrdiff_t(sizeof(ScalarType));
	ScalarType* const First = reinterpret_cast<ScalarType*>(Mip.Data) + Origin.X * StepX + Origin.Y * StepY;
	return bAlongX ? TLines<ScalarType>{First, StepX, StepY} : TLines<ScalarType>{First, StepY, StepX};
}

bool IsDoubleStorage(const FRHITexture& Texture)
{
	check(Texture.GetStorage() == ETexelStorage::RGBA32_FLOAT || Texture.GetStorage() == ETexelStorage::RGBA64_FLOAT);
	return Texture.GetStorage() == ETexelStorage::RGBA64_FLOAT;
}

int32 Along(FIntPoint Size, bool bAlongX)
{
	return bAlongX ? Size.X : Size.Y;
}

int32 Across(FIntPoint Size, bool bAlongX)
{
	return bAlongX ? Size.Y : Size.X;
}

/** Body(FirstLine, LastLine + 1) on all threads. */
void ForEachLines(int32 NumLines, TFunctionRef<void(int32, int32)> Body)
{
	ForEachTile(
		FKernelTile{0, 0, 0, NumLines, 1, 1}, FIntPoint(LinesPerTile, 1),
		[&](const FKernelTile& Tile) { Body(Tile.MinX, Tile.MaxX); }, EDenormals::Keep);
}

/** Real lines of NumIn texels, black beyond, to half spectra. */
template<typename ScalarType>
void TransformRealLines(
	const TLines<ScalarType>& In, FIntPoint InSize, const TLines<ScalarType>& Out, const FFourierTransform& Transform)
{
	const int32 Size = Transform.GetSize();
	ForEachLines(InSize.Y,
		[&](int32 Begin, int32 End)
		{
			std::vector<FComplex> Pair(static_cast<size_t>(Size)), Spectrum(static_cast<size_t>(Size));
			for (int32 Line = Begin; Line < End; Line += 2)
			{
				const bool bSecond = Line + 1 < End;
				for (int32 Channel = 0; Channel < NumChannels; ++Channel)
				{
					for (int32 X = 0; X < InSize.X; ++X)
					{
						Pair[size_t(X)] = FComplex(
							double(In.At(X, Line)[Channel]), bSecond ? double(In.At(X, Line + 1)[Channel]) : 0.0);
					}
					Transform.Run(Pair.data(), Spectrum.data());
					for (int32 K = 0; K <= Size / 2; ++K)
					{
						const FComplex A = Spectrum[size_t(K)];
						const FComplex B = std::conj(Spectrum[size_t((Size - K) & (Size - 1))]);
						const FComplex FirstValue = 0.5 * (A + B), Difference = 0.5 * (A - B);
						Out.At(2 * K, Line)[Channel] = ScalarType(FirstValue.real());
						Out.At(2 * K + 1, Line)[Channel] = ScalarType(FirstValue.imag());
						if (bSecond)
						{
							Out.At(2 * K, Line + 1)[Channel] = ScalarType(Difference.imag());
							Out.At(2 * K + 1, Line + 1)[Channel] = ScalarType(-Difference.real());
						}
					}
				}
				for (int32 Texel = 0; Texel < Size + 2; ++Texel)
				{
					Out.At(Texel, Line)[NumChannels] = ScalarType(0);
					if (bSecond)
					{
						Out.At(Texel, Line + 1)[NumChannels] = ScalarType(0);
					}
				}
			}
		});
}

/** The other axis, complex: for each of NumFrequencies, NumIn numbers across the lines, 0 beyond, to NumOut. */
template<typename ScalarType>
void TransformComplexLines(const TLines<ScalarType>& In, int32 NumIn, const TLines<ScalarType>& Out, int32 NumOut,
	int32 NumFrequencies, const FFourierTransform& Transform)
{
	const size_t Size = static_cast<size_t>(Transform.GetSize());
	ForEachLines(NumFrequencies,
		[&](int32 Begin, int32 End)
		{
			// Memory is walked in the order it lies in: all frequencies of the tile, line by line.
			const size_t NumSeries = static_cast<size_t>(End - Begin) * NumChannels;
			std::vector<FComplex> Series(NumSeries * Size);
			std::vector<FComplex> Result(Size);
			for (int32 Line = 0; Line < NumIn; ++Line)
			{
				FComplex* Value = &Series[size_t(Line)];
				for (int32 K = Begin; K < End; ++K)
				{
					const ScalarType *const Real = In.At(2 * K, Line), *const Imaginary = In.At(2 * K + 1, Line);
					for (int32 Channel = 0; Channel < NumChannels; ++Channel, Value += Size)
					{
						*Value = FComplex(double(Real[Channel]), double(Imaginary[Channel]));
					}
				}
			}
			for (size_t Index = 0; Index < NumSeries; ++Index)
			{
				FComplex* const First = &Series[Index * Size];
				Transform.Run(First, Result.data());
				std::copy_n(Result.begin(), Size, First);
			}
			for (int32 Line = 0; Line < NumOut; ++Line)
			{
				const FComplex* Value = &Series[size_t(Line)];
				for (int32 K = Begin; K < End; ++K)
				{
					ScalarType *const Real = Out.At(2 * K, Line), *const Imaginary = Out.At(2 * K + 1, Line);
					for (int32 Channel = 0; Channel < NumChannels; ++Channel, Value += Size)
					{
						Real[Channel] = ScalarType(Value->real());
						Imaginary[Channel] = ScalarType(Value->imag());
					}
					Real[NumChannels] = Imaginary[NumChannels] = ScalarType(0);
				}
			}
		});
}

/** Half spectra to real lines, times Scale; Write(Position, Line, Color) for the first NumOut texels. */
template<typename ScalarType, typename WriteType>
void TransformHalfSpectra(const TLines<ScalarType>& In, FIntPoint OutSize, double Scale,
	const FFourierTransform& Transform, const WriteType& Write)
{
	const int32 Size = Transform.GetSize();
	ForEachLines(OutSize.Y,
		[&](int32 Begin, int32 End)
		{
			std::vector<FComplex> Spectrum(static_cast<size_t>(Size));
			std::vector<FComplex> Pairs[NumChannels];
			for (std::vector<FComplex>& Pair : Pairs)
			{
				Pair.resize(static_cast<size_t>(Size));
			}
			for (int32 Line = Begin; Line < End; Line += 2)
			{
				const bool bSecond = Line + 1 < End;
				for (int32 Channel = 0; Channel < NumChannels; ++Channel)
				{
					for (int32 K = 0; K <= Size / 2; ++K)
					{
						const FComplex A(double(In.At(2 * K, Line)[Channel]), double(In.At(2 * K + 1, Line)[Channel]));
						const FComplex B = bSecond ? FComplex(double(In.At(2 * K, Line + 1)[Channel]),
														 double(In.At(2 * K + 1, Line + 1)[Channel]))
												   : FComplex(0.0, 0.0);
						// A + i B, and for the frequency of the other sign conj(A) + i conj(B).
						Spectrum[size_t(K)] = FComplex(A.real() - B.imag(), A.imag() + B.real());
						Spectrum[size_t((Size - K) & (Size - 1))] =
							K == 0 ? Spectrum[0] : FComplex(A.real() + B.imag(), B.real() - A.imag());
					}
					Transform.Run(Spectrum.data(), Pairs[Channel].data());
				}
				for (int32 X = 0; X < OutSize.X; ++X)
				{
					const FComplex R = Pairs[0][size_t(X)] * Scale, G = Pairs[1][size_t(X)] * Scale,
								   B = Pairs[2][size_t(X)] * Scale;
					Write(X, Line, FVector4(R.real(), G.real(), B.real(), 0.0));
					if (bSecond)
					{
						Write(X, Line + 1, FVector4(R.imag(), G.imag(), B.imag(), 0.0));
					}
				}
			}
		});
}

/** A texture for spectra; by default of the whole one. */
FRDGTextureRef CreateSpectrum(FRDGBuilder& GraphBuilder, FIntPoint Extent, const TCHAR* Name)
{
	return GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, PF_A32B32G32R32F, FClearValueBinding::None,
										  TexCreate_ShaderResource | TexCreate_UAV),
		Name);
}

/** Before the second axis: as many lines as the picture has. */
FIntPoint GetIntermediateExtent(const FFFTDomain& Domain, FIntPoint PictureSize)
{
	const FIntPoint Extent = Domain.GetSpectrumExtent();
	return Domain.bHorizontalFirst ? FIntPoint(Extent.X, PictureSize.Y) : FIntPoint(PictureSize.X, Extent.Y);
}

FFFTPassParameters* MakeParameters(FRDGBuilder& GraphBuilder, FRDGTextureRef Input, FRDGTextureRef Output)
{
	FFFTPassParameters* Parameters = GraphBuilder.AllocParameters<FFFTPassParameters>();
	Parameters->Input = Input;
	Parameters->Output = Output;
	return Parameters;
}

/** Calls Function with a float or a double of the textures' storage; both have the same. */
template<typename FunctionType>
void WithScalar(FRHITexture& Input, FRHITexture& Output, const FunctionType& Function)
{
	Input.EnsureMemory();
	Output.EnsureMemory();
	const bool bDouble = IsDoubleStorage(Input);
	check(bDouble == IsDoubleStorage(Output));
	if (bDouble)
	{
		Function(double());
	}
	else
	{
		Function(float());
	}
}

const TCHAR* GetAxisName(bool bAlongX)
{
	return bAlongX ? TEXT("rows") : TEXT("columns");
}

/** The complex axis, in either direction. NumIn, NumOut: numbers of a line that are there, and that are wanted. */
void AddComplexPass(FRDGBuilder& GraphBuilder, const FFFTDomain& Domain, FRDGTextureRef Input, FRDGTextureRef Output,
	EFourierDirection Direction)
{
	const bool bAlongX = Domain.bHorizontalFirst;
	const FFFTPassParameters* Parameters = MakeParameters(GraphBuilder, Input, Output);
	const FIntPoint InSize = Input->Desc.Extent, OutSize = Output->Desc.Extent;
	GraphBuilder.AddPass(RDG_EVENT_NAME("FFTBloom.%s %s %dx%d",
							 Direction == EFourierDirection::Forward ? TEXT("FFT") : TEXT("InverseFFT"),
							 GetAxisName(!bAlongX), OutSize.X, OutSize.Y),
		Parameters, ERDGPassFlags::Compute,
		[=](FRHIComputeCommandList&)
		{
			FRHITexture &Source = *Parameters->Input->GetRHI(), &Target = *Parameters->Output->GetRHI();
			const FFourierTransform Transform(Across(Domain.FrequencySize, bAlongX), Direction);
			WithScalar(Source, Target,
				[&](auto Scalar)
				{
					using ScalarType = decltype(Scalar);
					TransformComplexLines(GetLines<ScalarType>(Source, FIntPoint::ZeroValue, bAlongX),
						Across(InSize, bAlongX), GetLines<ScalarType>(Target, FIntPoint::ZeroValue, bAlongX),
						Across(OutSize, bAlongX), Along(Domain.FrequencySize, bAlongX) / 2 + 1, Transform);
				});
		});
}

} // namespace

FRDGTextureRef AddForwardFFTPasses(
	FRDGBuilder& GraphBuilder, const FFFTDomain& Domain, const FScreenPassTexture& Image, const TCHAR* Name)
{
	check(Image.IsValid() && Image.Texture->Desc.Format == PF_A32B32G32R32F);
	const FIntRect Rect = Image.ViewRect;
	check(Rect.Width() <= Domain.FrequencySize.X && Rect.Height() <= Domain.FrequencySize.Y);
	const bool bAlongX = Domain.bHorizontalFirst;
	const FIntPoint Extent = GetIntermediateExtent(Domain, Rect.Size());
	const FRDGTextureRef Intermediate = CreateSpectrum(GraphBuilder, Extent, TEXT("Bloom.FFTIntermediate"));

	const FFFTPassParameters* Parameters = MakeParameters(GraphBuilder, Image.Texture, Intermediate);
	GraphBuilder.AddPass(RDG_EVENT_NAME("FFTBloom.FFT %s %dx%d", GetAxisName(bAlongX), Extent.X, Extent.Y), Parameters,
		ERDGPassFlags::Compute,
		[=](FRHIComputeCommandList&)
		{
			FRHITexture &Source = *Parameters->Input->GetRHI(), &Target = *Parameters->Output->GetRHI();
			const FFourierTransform Transform(Along(Domain.FrequencySize, bAlongX), EFourierDirection::Forward);
			const FIntPoint InSize(Along(Rect.Size(), bAlongX), Across(Rect.Size(), bAlongX));
			WithScalar(Source, Target,
				[&](auto Scalar)
				{
					using ScalarType = decltype(Scalar);
					TransformRealLines(GetLines<ScalarType>(Source, Rect.Min, bAlongX), InSize,
						GetLines<ScalarType>(Target, FIntPoint::ZeroValue, bAlongX), Transform);
				});
		});

	const FRDGTextureRef Spectrum = CreateSpectrum(GraphBuilder, Domain.GetSpectrumExtent(), Name);
	AddComplexPass(GraphBuilder, Domain, Intermediate, Spectrum, EFourierDirection::Forward);
	return Spectrum;
}

void AddInverseFFTPasses(
	FRDGBuilder& GraphBuilder, const FFFTDomain& Domain, FRDGTextureRef Spectrum, const FScreenPassTexture& Output)
{
	check(Spectrum->Desc.Extent == Domain.GetSpectrumExtent());
	const FIntRect Rect = Output.ViewRect;
	check(Rect.Width() <= Domain.FrequencySize.X && Rect.Height() <= Domain.FrequencySize.Y);
	const bool bAlongX = Domain.bHorizontalFirst;
	const FRDGTextureRef Intermediate =
		CreateSpectrum(GraphBuilder, GetIntermediateExtent(Domain, Rect.Size()), TEXT("Bloom.FFTIntermediate"));
	AddComplexPass(GraphBuilder, Domain, Spectrum, Intermediate, EFourierDirection::Inverse);

	const FFFTPassParameters* Parameters = MakeParameters(GraphBuilder, Intermediate, Output.Texture);
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("FFTBloom.InverseFFT %s %dx%d", GetAxisName(bAlongX), Rect.Width(), Rect.Height()), Parameters,
		ERDGPassFlags::Compute,
		[=](FRHIComputeCommandList&)
		{
			FRHITexture &Source = *Parameters->Input->GetRHI(), &Target = *Parameters->Output->GetRHI();
			Source.EnsureMemory();
			Target.EnsureMemory();
			const FFourierTransform Transform(Along(Domain.FrequencySize, bAlongX), EFourierDirection::Inverse);
			const FIntPoint OutSize(Along(Rect.Size(), bAlongX), Across(Rect.Size(), bAlongX));
			const double Scale = 1.0 / (double(Domain.FrequencySize.X) * double(Domain.FrequencySize.Y));
			const auto Write = [&](int32 Position, int32 Line, const FVector4& Color)
			{
				const FIntPoint Texel = Rect.Min + (bAlongX ? FIntPoint(Position, Line) : FIntPoint(Line, Position));
				Target.WriteTexelDouble(Texel.X, Texel.Y, Color);
			};
			if (IsDoubleStorage(Source))
			{
				TransformHalfSpectra(
					GetLines<double>(Source, FIntPoint::ZeroValue, bAlongX), OutSize, Scale, Transform, Write);
			}
			else
			{
				TransformHalfSpectra(
					GetLines<float>(Source, FIntPoint::ZeroValue, bAlongX), OutSize, Scale, Transform, Write);
			}
		});
}

} // namespace Drydock
