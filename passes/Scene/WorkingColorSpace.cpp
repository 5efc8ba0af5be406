// Fills the uniform buffer of the working colour space from the published primaries of Rec.709, AP0 and AP1.
#include "WorkingColorSpace.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FWorkingColorSpaceShaderParameters, "WorkingColorSpace");

namespace
{

FMatrix44f MakeMatrix(const double (&Rows)[3][3])
{
	FMatrix44f Matrix = FMatrix44f::Identity;
	for (int32 Row = 0; Row < 3; ++Row)
	{
		for (int32 Column = 0; Column < 3; ++Column)
		{
			Matrix.M[Row][Column] = static_cast<float>(Rows[Row][Column]);
		}
	}
	return Matrix;
}

FWorkingColorSpaceShaderParameters MakeRec709()
{
	FWorkingColorSpaceShaderParameters Parameters;
	Parameters.ToXYZ = MakeMatrix({{0.4123907993, 0.3575843394, 0.1804807884},
		{0.2126390059, 0.7151686788, 0.0721923154}, {0.0193308187, 0.1191947798, 0.9505321522}});
	Parameters.FromXYZ = MakeMatrix({{3.2409699419, -1.5373831776, -0.4986107603},
		{-0.9692436363, 1.8759675015, 0.0415550574}, {0.0556300797, -0.2039769589, 1.0569715142}});
	Parameters.ToAP1 = MakeMatrix({{0.6130974024, 0.3395231462, 0.0473794514},
		{0.0701937225, 0.9163538791, 0.0134523985}, {0.0206155929, 0.1095697729, 0.8698146342}});
	Parameters.FromAP1 = MakeMatrix({{1.7050509927, -0.6217921207, -0.0832588720},
		{-0.1302564175, 1.1408047366, -0.0105483191}, {-0.0240033568, -0.1289689761, 1.1529723329}});
	Parameters.ToAP0 = MakeMatrix({{0.4396329819, 0.3829886982, 0.1773783199},
		{0.0897764430, 0.8134394287, 0.0967841283}, {0.0175411704, 0.1115465533, 0.8709122763}});
	Parameters.bIsSRGB = 1;
	return Parameters;
}

} // namespace

FDefaultWorkingColorSpaceUniformBuffer GDefaultWorkingColorSpaceUniformBuffer;

const TUniformBufferRef<FWorkingColorSpaceShaderParameters>&
FDefaultWorkingColorSpaceUniformBuffer::GetUniformBufferRef() const
{
	static const TUniformBufferRef<FWorkingColorSpaceShaderParameters> Buffer =
		TUniformBufferRef<FWorkingColorSpaceShaderParameters>::CreateUniformBufferImmediate(
			MakeRec709(), UniformBuffer_MultiFrame);
	return Buffer;
}
